// The line and the plane: the same code as for space.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <catch2/catch.hpp>
#include <set>

#include "extensions/bsp/partition_data.h"
#include "support/random.h"
#include "support/rounds.h"

namespace strata::bsp {
namespace {

using test::Random;

/// Intervals as the unit steps between small integers that they cover, -inf and inf included.
struct Steps {
  static constexpr int lowest = -8, highest = 8;  ///< step k is from k to k + 1
  std::set<int> covered;
  bool below = false, above = false;
};

std::pair<std::vector<Interval>, Steps> random_intervals(Random& random) {
  std::vector<Interval> intervals;
  Steps steps;
  for (int n = random.between(0, 4); n > 0; --n) {
    Interval i;
    const int from = random.between(-7, 6), to = random.between(from, 7);
    const bool has_lower = !random.once_in(6), has_upper = !random.once_in(6);
    if (has_lower) i.lower = from;
    if (has_upper) i.upper = to;
    for (int k = Steps::lowest; k < Steps::highest; ++k)
      if ((!has_lower || k >= from) && (!has_upper || k < to)) steps.covered.insert(k);
    steps.below |= !has_lower;
    steps.above |= !has_upper;
    intervals.push_back(i);
  }
  return {intervals, steps};
}

template <class Rule>
Steps combined(const Steps& a, const Steps& b, Rule rule) {
  Steps r{{}, rule(a.below, b.below), rule(a.above, b.above)};
  for (int k = Steps::lowest; k < Steps::highest; ++k)
    if (rule(a.covered.count(k) != 0, b.covered.count(k) != 0)) r.covered.insert(k);
  return r;
}

void check_equal(const Partition<1>& region, const Steps& steps) {
  for (int k = Steps::lowest; k < Steps::highest; ++k) {
    const bool here = steps.covered.count(k) != 0;
    CHECK(region.classify(std::array{k + 0.5}) == (here ? Where::in : Where::out));
    if (k == Steps::lowest) continue;
    const bool before = steps.covered.count(k - 1) != 0;
    CHECK(region.classify(std::array{k * 1.0}) == (here == before ? here ? Where::in : Where::out : Where::on));
  }
  CHECK(region.classify(std::array{-1e9}) == (steps.below ? Where::in : Where::out));
  CHECK(region.classify(std::array{1e9}) == (steps.above ? Where::in : Where::out));
  CHECK(region.is_bounded() == (!steps.below && !steps.above));
  if (region.is_bounded()) CHECK(size(region) == Rational(static_cast<long>(steps.covered.size())));
  std::vector<Interval> again = intervals_of(region);
  CHECK(partition_of(again) == region);
}

namespace geometry = boost::geometry;
using Point = geometry::model::d2::point_xy<long long>;
using Polygon = geometry::model::polygon<Point, false, false>;
using Polygons = geometry::model::multi_polygon<Polygon>;

/// A union of rectangles with corners of integers: holes, parts that touch, all as Boost.Geometry has it. Sides are
/// axis-parallel, so its crossings are integers and it is exact.
Polygons random_rectangles(Random& random) {
  Polygons all;
  for (int n = random.between(1, 6); n > 0; --n) {
    const long long x = random.between(0, 7), y = random.between(0, 7), w = random.between(1, 4),
                    h = random.between(1, 4);
    Polygon one;
    for (const auto& [px, py] : {std::pair{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}})
      geometry::append(one.outer(), Point(px, py));
    Polygons sum;
    geometry::union_(all, one, sum);
    all = sum;
  }
  return all;
}

Partition<2> region_of(const Polygons& polygons) {
  std::vector<PolygonLoop> loops;
  const auto add = [&](const auto& ring) {
    PolygonLoop loop;
    for (const Point& p : ring)
      loop.push_back({Rational(static_cast<long>(p.x())), Rational(static_cast<long>(p.y()))});
    loops.push_back(loop);
  };
  for (const Polygon& p : polygons) {
    add(p.outer());
    for (const auto& hole : p.inners()) add(hole);
  }
  return partition_of(loops);
}

/// A triangle with small rational corners, counter-clockwise.
Partition<2> random_triangle(Random& random) {
  while (true) {
    PolygonLoop loop;
    for (int i = 0; i < 3; ++i)
      loop.push_back({Rational(random.between(0, 6), random.between(1, 2)), random.between(0, 4)});
    const Rational orientation =
        (loop[1][0] - loop[0][0]) * (loop[2][1] - loop[0][1]) - (loop[1][1] - loop[0][1]) * (loop[2][0] - loop[0][0]);
    if (orientation == 0) continue;
    if (orientation < 0) std::swap(loop[1], loop[2]);
    return partition_of(std::vector<PolygonLoop>{loop});
  }
}

Partition<2> random_half_plane(Random& random) {
  const RationalVector<2> p{random.between(-1, 5), random.between(-1, 5)};
  RationalVector<2> q = p;
  while (q == p) q = {random.between(-1, 5), random.between(-1, 5)};
  return behind(line_through(p, q));
}

}  // namespace

TEST_CASE("sets of intervals are what their unit steps say, in 10,000 random cases", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(10'000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto [first, a_steps] = random_intervals(random);
    const auto [second, b_steps] = random_intervals(random);
    const Partition<1> a = partition_of(first), b = partition_of(second);
    check_equal(a, a_steps);
    check_equal(a | b, combined(a_steps, b_steps, [](bool x, bool y) { return x || y; }));
    check_equal(a & b, combined(a_steps, b_steps, [](bool x, bool y) { return x && y; }));
    check_equal(a - b, combined(a_steps, b_steps, [](bool x, bool y) { return x && !y; }));
    check_equal(a ^ b, combined(a_steps, b_steps, [](bool x, bool y) { return x != y; }));
    check_equal(complement(a), combined(a_steps, b_steps, [](bool x, bool) { return !x; }));
  }
}

TEST_CASE("a point is no region of the line", "[bsp]") {
  CHECK(partition_of(std::vector<Interval>{{Rational(1), Rational(1)}}).is_empty());
  CHECK(partition_of(std::vector<Interval>{{std::nullopt, Rational(1)}, {Rational(1), std::nullopt}}).is_full());
  CHECK(barycentre(partition_of(std::vector<Interval>{{Rational(0), Rational(1)}, {Rational(2), Rational(5)}})) ==
        RationalVector<1>{Rational(11, 4)});
  CHECK(boundary_size(partition_of(std::vector<Interval>{{Rational(0), Rational(1)}})) == 2);
}

TEST_CASE("areas of combined rectangles are those of Boost.Geometry, in 10,000 random cases", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(10'000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Polygons a = random_rectangles(random), b = random_rectangles(random);
    const Partition<2> p = region_of(a), q = region_of(b);
    Polygons both, any, rest;
    geometry::intersection(a, b, both);
    geometry::union_(a, b, any);
    geometry::difference(a, b, rest);
    const auto area = [](const Polygons& x) { return Rational(static_cast<long>(2 * geometry::area(x) + 0.5)) / 2; };
    CHECK(size(p) == area(a));
    CHECK(size(p & q) == area(both));
    CHECK(size(p | q) == area(any));
    CHECK(size(p - q) == area(rest));
    CHECK((p & q) == region_of(both));
    CHECK(boundary_size(p | q) == static_cast<double>(geometry::perimeter(any)));
  }
}

TEST_CASE("laws hold in the plane for triangles, half-planes and complements, in 10,000 random cases",
          "[bsp][property]") {
  const auto region = [](Random& random) {
    Partition<2> r = random.once_in(3) ? random_half_plane(random) : random_triangle(random);
    if (random.once_in(2)) r = r - random_triangle(random);
    return random.once_in(4) ? complement(r) : r;
  };
  for (std::uint64_t seed = 0; seed < test::rounds(10'000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Partition<2> a = region(random), b = region(random);
    const Partition<2> any = a | b, both = a & b;
    CHECK(complement(any) == (complement(a) & complement(b)));
    CHECK((a ^ b) == (any - both));
    CHECK((a ^ a).is_empty());
    CHECK(complement(complement(a)) == a);
    if (a.is_bounded() && b.is_bounded()) {
      CHECK(*size(a) + *size(b) == *size(any) + *size(both));
      CHECK(partition_of(sides_of(any)) == any);
    }
    CHECK(rebuilt(a ^ b) == (a ^ b));
  }
}

TEST_CASE("a polygon with a hole", "[bsp]") {
  const std::vector<PolygonLoop> loops{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  const Partition<2> r = partition_of(loops);
  CHECK(size(r) == Rational(35));
  CHECK(boundary_size(r) == 28);
  CHECK(r.classify({1.5, 1.5}) == Where::out);
  CHECK(r.classify({1.0, 1.5}) == Where::on);
  CHECK(r.classify({0.5, 1.5}) == Where::in);
  CHECK(intersection<2>(r, {{-1, Rational(3, 2)}, {1, 0}}) ==
        std::vector<Interval>{{Rational(1), Rational(2)}, {Rational(3), Rational(7)}});
}

}  // namespace strata::bsp
