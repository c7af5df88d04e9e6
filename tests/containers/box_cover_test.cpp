#include "core/containers/box_cover.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "support/random.h"

using namespace strata;

namespace {

Box random_box(test::Random& random, double scale) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = scale * static_cast<double>(random.between(-20, 20));
    box.upper[i] = box.lower[i] + scale * static_cast<double>(random.between(0, random.once_in(8) ? 30 : 2));
  }
  return box;
}

}  // namespace

TEST_CASE("a cover meets what one of its boxes meets", "[containers][property]") {
  test::Random random(4);
  for (const double scale : {1.0, 0x1p-1070, 0x1p1017}) {
    for (int round = 0; round < 60; ++round) {
      std::vector<Box> boxes(static_cast<std::size_t>(random.between(1, 40)));
      for (Box& b : boxes) b = random_box(random, scale);
      const BoxCover cover(boxes);
      for (int n = 0; n < 100; ++n) {
        const Box asked = random_box(random, scale);
        const bool meets = std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return b.overlaps(asked); });
        REQUIRE(cover.meets(asked) == meets);
      }
    }
  }
}

TEST_CASE("a cover of boxes without extent", "[containers]") {
  const Box point{{1, 2, 3}, {1, 2, 3}};
  const BoxCover cover({point, point});
  CHECK(cover.meets(point));
  CHECK(cover.meets({{0, 0, 0}, {1, 2, 3}}));
  CHECK_FALSE(cover.meets({{0, 0, 0}, {1, 2, 2.5}}));
  CHECK_FALSE(BoxCover({}).meets(point));
}
