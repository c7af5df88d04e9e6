#include "core/containers/box_sweep.h"

#include <catch2/catch.hpp>
#include <random>

using namespace strata;

// Seen to fail: a sweep that ends at the first box that begins where another one ends.

TEST_CASE("a sweep finds the pairs of boxes that overlap", "[containers][property]") {
  const unsigned seed = GENERATE(range(0u, 60u));
  std::mt19937 random(seed);
  std::vector<Box> boxes(random() % 120);
  for (Box& b : boxes) {
    if (random() % 10 == 0) continue;  // empty
    for (std::size_t i = 0; i < 3; ++i) {
      b.lower[i] = static_cast<double>(random() % (seed % 3 == i ? 3u : 20u));
      b.upper[i] = random() % 40 == 0 ? Box::infinity : b.lower[i] + static_cast<double>(random() % 5);
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t a = 0; a < boxes.size(); ++a)
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
      if (boxes[a].overlaps(boxes[b])) expected.emplace_back(a, b);
  CHECK(overlapping_pairs(boxes) == expected);
}

TEST_CASE("no boxes have no pairs", "[containers]") {
  CHECK(overlapping_pairs({}).empty());
  CHECK(overlapping_pairs(std::vector<Box>(3)).empty());
}
