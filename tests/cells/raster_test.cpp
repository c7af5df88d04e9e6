#include "core/cells/raster.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "support/random.h"

using namespace strata;

namespace {

struct Scene {
  std::vector<InputComplex::Coordinates> points;
  std::vector<InputComplex::Indices> faces;
  InputComplex input;
};

}  // namespace

// Faces long and thin, tilted and straight, near the origin and far away.
TEST_CASE("a brick that holds a point of a face has the face", "[cells][property]") {
  test::Random random(5);
  for (const double scale : {1e-300, 1e-3, 1.0, 1e200})
    for (const double far : {0.0, 1e3}) {
      Space space;
      InputComplex::Coordinates lower, upper;
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = (far - 1) * scale;
        upper[i] = (far + 1) * scale;
      }
      space.grid = Grid(lower, upper);
      space.interest = {space.grid.at(lower), space.grid.at(upper)};
      for (std::int32_t& x : space.interest.upper) ++x;
      space.corner = lower;
      const BrickGrid bricks(space, 40'000, 1);
      REQUIRE(bricks.brick_count() > 1000);
      for (int n = 0; n < 60; ++n) {
        Scene s;
        const auto coordinate = [&] { return (far + (random.once_in(4) ? 0.25 : random.unit() * 2 - 1)) * scale; };
        for (int k = 0; k < 3; ++k) s.points.push_back({coordinate(), coordinate(), coordinate()});
        s.faces.push_back({0, 1, 2});
        s.input.add(s.points, s.faces);
        const Raster raster(s.input, bricks);
        BrickBox box{0xffffffu, 0};
        for (const auto& p : s.points) {
          const BrickCode code = bricks.code(space.grid.at(p));
          box = {lower_corner(box.lower, code), upper_corner(box.upper, code)};
        }
        std::set<std::uint32_t> named;
        raster.for_each_brick(s.points[0], s.points[1], s.points[2], box,
                              [&](std::uint32_t brick) { REQUIRE(named.insert(brick).second); });
        REQUIRE(named.size() <= box.size());
        for (int k = 0; k < 300; ++k) {
          // Rounded, a point of the face is off its plane by an ulp or so: less than the filter leaves open.
          const double a = random.unit(), b = random.unit() * (1 - a), c = 1 - a - b;
          InputComplex::Coordinates q;
          for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax({s.points[0][i], s.points[1][i], s.points[2][i]});
            q[i] = std::clamp(a * s.points[0][i] + b * s.points[1][i] + c * s.points[2][i], low, high);
          }
          REQUIRE(named.count(bricks.index(bricks.code(space.grid.at(q)))) == 1);
        }
      }
    }
}

TEST_CASE("every brick has its centre and its lower bound", "[cells]") {
  Space space;
  const InputComplex::Coordinates lower{-1, 2, 1e-9}, upper{3, 2.5, 1};
  space.grid = Grid(lower, upper);
  space.interest = {space.grid.at(lower), space.grid.at(upper)};
  for (std::int32_t& x : space.interest.upper) ++x;
  space.corner = lower;
  const BrickGrid bricks(space, 5'000, 1);
  for (std::uint32_t b = 0; b < bricks.brick_count(); ++b) {
    const BrickCode code = bricks.code_of(b);
    REQUIRE(bricks.index(code) == b);
    if (bricks.is_outside(code)) continue;
    REQUIRE(bricks.code(space.grid.at(bricks.centre(code))) == code);
    REQUIRE(bricks.box(code).holds(space.grid.at(bricks.centre(code))));
  }
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint32_t k = 1; k < bricks.size(axis); ++k) {
      const auto code_at = [&](double x) {
        InputComplex::Coordinates p = lower;
        p[static_cast<std::size_t>(axis)] = x;
        return BrickBox::along(bricks.code(space.grid.at(p)), axis);
      };
      const double x = bricks.lower_bound(axis, k);
      REQUIRE(code_at(x) >= k);
      // The grid starts with the space: all that is below counts as its first step.
      if (k > 1) REQUIRE(code_at(std::nextafter(x, -1e300)) < k);
    }
}
