#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "strata/planar.h"

using namespace strata;
using namespace strata::planar;

namespace {

/// What the law promises of a rounded region.
void check_rounded(const Region& region, const RoundedRegion& rounded, const CoordinateGrid& grid = {}) {
  CHECK(validate(rounded.region).empty());
  CHECK(rounding_conflicts(rounded.region).empty());
  const Places& places = rounded.region.loops.places;
  for (const std::uint32_t v : rounded.region.loops.vertices) {
    REQUIRE(places.is_double(v));
    if (grid.step > 0)
      for (const double x : places.place[v]) {
        const double steps = std::nearbyint(to_nearest_double(Rational(to_rational(x) / grid.step)));
        CHECK(to_nearest_double(Rational(Rational(steps) * grid.step)) == x);
      }
  }
  const RoundedRegion again = round_to_region(rounded.region, grid);
  CHECK(again.rounds == 0);
  CHECK(again.largest_movement == 0);
  CHECK(canonical_form(again.region) == canonical_form(rounded.region));
  // What changed is within the movement of both boundaries.
  double length = 0;
  std::size_t vertices = 0;
  for (const Region* r : {&region, &rounded.region})
    for (std::uint32_t l = 0; l < r->loops.size(); ++l) {
      const auto loop = r->loops.loop(l);
      vertices += loop.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PlanePoint &p = r->loops.places.place[loop[i]], &q = r->loops.places.place[loop[(i + 1) % loop.size()]];
        length += std::hypot(p[0] - q[0], p[1] - q[1]);
      }
    }
  const double m = rounded.largest_movement;
  CHECK(to_nearest_double(area(symmetric_difference(region, rounded.region))) <=
        4 * m * (length + double(vertices) * m));
}

std::vector<PlanePoint> sliver(std::mt19937& random, double width) {
  std::uniform_real_distribution<double> at(-1, 1);
  const PlanePoint p{at(random), at(random)}, q{at(random), at(random)};
  return {p, q, {q[0] + width * at(random), q[1] + width * at(random)}, {p[0] + width * at(random), p[1]}};
}

}  // namespace

TEST_CASE("a region of doubles is not changed by rounding", "[planar]") {
  Loops loops;
  loops.add(std::vector<PlanePoint>{{0, 0}, {3, 0}, {0, 3}});
  const Region region = fill(loops);
  const RoundedRegion rounded = round_to_region(region);
  CHECK(rounded.rounds == 0);
  CHECK(rounded.largest_movement == 0);
  CHECK(canonical_form(rounded.region) == canonical_form(region));
  CHECK(round_to_region(Region{}).region.empty());
}

TEST_CASE("crossing slivers become regions of doubles and of multiples of a step", "[planar][property]") {
  std::size_t rearranged = 0;
  std::uint32_t most_rounds = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Loops loops;
    const double width = std::ldexp(1.0, -static_cast<int>(seed % 60));
    for (unsigned i = 0; i < 4 + seed % 13; ++i) loops.add(sliver(random, width));
    const Region region = fill(Operand(loops, seed % 2 == 0 ? FillRule::nonzero : FillRule::even_odd));
    const RoundedRegion rounded = round_to_region(region);
    rearranged += rounding_conflicts(region).empty() ? 0 : 1;
    check_rounded(region, rounded);
    CHECK(rounded.largest_movement <= (rounded.rounds + 1) * 0x1p-51);
    most_rounds = std::max(most_rounds, rounded.rounds);
    for (const Rational& step : {Rational(1, 1000), Rational(1, 8)}) {
      const CoordinateGrid grid{CoordinateGrid::Format::float64, step};
      check_rounded(region, round_to_region(region, grid), grid);
    }
    check_rounded(region, round_to_region(region, {CoordinateGrid::Format::float32, 0}));
  }
  CHECK(rearranged > 20);
  CHECK(most_rounds > 0);
  CHECK(most_rounds < 5);
}

TEST_CASE("long slivers on a coarse grid end in few rounds, near where they were", "[planar][property]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::int64_t> at(-1000000000000, 1000000000000), width(1, 6);
    Loops loops;
    for (int i = 0; i < 30; ++i) {
      const std::array<double, 4> p{double(at(random)), double(at(random)), double(at(random)), double(at(random))};
      const double w = double(width(random));
      loops.add(std::vector<PlanePoint>{{p[0], p[1]}, {p[2], p[3]}, {p[2] + w, p[3] + w}, {p[0] + w, p[1] + w}});
    }
    const Region region = fill(Operand(loops, FillRule::even_odd));
    const CoordinateGrid integers{CoordinateGrid::Format::float64, Rational(1)};
    const RoundedRegion rounded = round_to_region(region, integers);
    check_rounded(region, rounded, integers);
    CHECK(rounded.rounds <= 6);
    CHECK(rounded.largest_movement <= 4);
    CHECK(rounded.region.polygons() > 1);
  }
}

TEST_CASE("what the grid cannot hold vanishes", "[planar]") {
  Loops loops;
  loops.add(std::vector<PlanePoint>{{0, 0}, {1, 0}, {1, 0.001}, {0, 0.001}});
  const CoordinateGrid tenths{CoordinateGrid::Format::float64, Rational(1, 10)};
  CHECK(round_to_region(fill(loops), tenths).region.empty());
  CHECK_THROWS_AS(round_to_region(fill(loops), {CoordinateGrid::Format::float64, Rational(-1)}), std::invalid_argument);
  Loops huge;
  huge.add(std::vector<PlanePoint>{{0, 0}, {1e39, 0}, {0, 1}});
  CHECK_THROWS_AS(round_to_region(fill(huge), {CoordinateGrid::Format::float32, 0}), std::invalid_argument);
  CHECK(round_to_region(fill(huge)).rounds == 0);
}

TEST_CASE("regions among the smallest doubles end", "[planar]") {
  const double tiny = 4.9406564584124654e-324;
  Loops loops;
  loops.add(std::vector<PlanePoint>{{0, 0}, {5 * tiny, 0}, {0, 3 * tiny}});
  loops.add(std::vector<PlanePoint>{{0, 4 * tiny}, {tiny, -tiny}, {4 * tiny, 2 * tiny}});
  const Region region = fill(Operand(loops, FillRule::even_odd));
  const RoundedRegion rounded = round_to_region(region);
  CHECK(validate(rounded.region).empty());
  CHECK(rounding_conflicts(rounded.region).empty());
}
