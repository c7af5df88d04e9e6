#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "strata/convex.h"
#include "support/shapes.h"

namespace strata::convex {

TEST_CASE("balls contain a sphere and lie in a slightly larger one", "[convex][offset]") {
  for (const double radius : {1.0, 0.1, 1e-200, 3e250, 7.5})
    for (const std::uint32_t facets : {20U, 80U, 320U, 5000U}) {
      CAPTURE(radius, facets);
      const Ball found = ball(radius, facets);
      CHECK(found.polytope.facets.size() > facets / 2);
      CHECK(found.polytope.facets.size() < facets * 2);
      CHECK(found.excess < 6.0 / facets);
      CHECK(found.polytope.exact.empty());
      const Rational r = to_rational(radius), largest = r * (1 + to_rational(found.excess));
      for (std::uint32_t v = 0; v < found.polytope.vertices.size(); ++v) {
        const RationalPoint p = found.polytope.position(v);
        REQUIRE(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= largest * largest);
      }
    }
}

TEST_CASE("what makes no ball is refused", "[convex][offset]") {
  CHECK_THROWS_AS(ball(0, 80), std::invalid_argument);
  CHECK_THROWS_AS(ball(-1, 80), std::invalid_argument);
  CHECK_THROWS_AS(ball(std::nan(""), 80), std::invalid_argument);
  CHECK_THROWS_AS(ball(1, 19), std::invalid_argument);
}

TEST_CASE("offsets grow, shrink, close what is narrow and end at nothing", "[convex][offset]") {
  const Solid cube{test::box({0, 0, 0}, {4, 4, 4})};
  CHECK(offset(cube, 0).solid == cube);
  const Offset grown = offset(cube, 0.5, 80);
  const double exact = 64 + 6 * 16 * 0.5 + 12 * 4 * 0.25 * std::numbers::pi * 0.25 + 4 * std::numbers::pi / 3 * 0.125;
  const double volume = to_nearest_double(grown.solid.volume());
  CHECK(volume > exact);
  CHECK(volume < exact * (1 + grown.excess));
  const Solid shrunk = offset(cube, -0.5, 80).solid;
  const double side = std::cbrt(to_nearest_double(shrunk.volume()));
  CHECK(side <= 3);
  CHECK(side > 3 - 2 * 0.5 * grown.excess);
  CHECK(offset(cube, -2.5, 80).solid.is_empty());
  const Solid hollow{test::box_with_cavity(1)};
  CHECK(offset(hollow, 0.75, 80).solid == minkowski_sum(cube, ball(0.75, 80).polytope));
  CHECK((hollow - offset(hollow, 0.25, 80).solid).is_empty());
}

}  // namespace strata::convex
