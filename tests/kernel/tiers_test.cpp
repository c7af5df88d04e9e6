#include "kernel/tiers.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/kernel/predicates.h"

using namespace strata;
using namespace strata::test;

namespace {

/// Asks once and checks the answer and the one tier that gave it.
template <class Question>
void check_tier(Tier tier, Sign expected, const Question& question) {
  TierProbe probe;
  CHECK(question() == expected);
  if (!counts_tiers) return;
  TierProbe::Counts only{};
  only[static_cast<std::size_t>(tier)] = 1;
  CHECK(probe.take() == only);
}

struct Given {
  explicit Given(std::vector<InputComplex::Coordinates> p, std::vector<InputComplex::Indices> f = {})
      : points(std::move(p)), faces(std::move(f)) {
    input.add(points, faces);
  }
  [[nodiscard]] Point point(const SymbolicPoint& name) const { return make_point(input, name); }

  std::vector<InputComplex::Coordinates> points;
  std::vector<InputComplex::Indices> faces;
  InputComplex input;
};

/// Four vertices in the plane x + y + z = 0, on a lattice of b + 1 bits; so small that products of doubles vanish.
Given coplanar(int b) {
  const double unit = std::numeric_limits<double>::denorm_min(), m = std::ldexp(unit, b);
  return Given({{0, m, -m}, {m, -m, 0}, {-m, 0, m}, {2 * unit, -unit, -unit}});
}

}  // namespace

TEST_CASE("four vertices in general position are the filter's", "[kernel]") {
  const Given g({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  check_tier(Tier::filter, Sign::positive, [&] { return orient3d(g.input, 0U, 1U, 2U, 3U); });
  check_tier(Tier::filter, Sign::negative, [&] { return orient3d(g.input, 1U, 0U, 2U, 3U); });
}

TEST_CASE("a vertex that occurs twice, and planes across an axis, need no integers", "[kernel]") {
  const Given g({{0, 0, 7}, {1, 0, 7}, {0, 1, 7}, {5, 5, 7}});
  check_tier(Tier::filter, Sign::zero, [&] { return orient3d(g.input, 0U, 1U, 2U, 1U); });
  check_tier(Tier::filter, Sign::zero, [&] { return orient3d(g.input, 0U, 1U, 2U, 3U); });
  const Given tilted({{0, 0, 7}, {1, 0, 8}, {0, 1, 9}});
  check_tier(Tier::filter, Sign::zero, [&] { return orient3d(tilted.input, 0U, 1U, 1U, 2U); });
}

// Catches: edges along different axes taken for parallel.
TEST_CASE("two edges along one axis need no integers, whatever their order", "[kernel]") {
  const double x = 0.1, y = 0.7, z = 1e17;  // differences and products round
  const Given walls({{x, y, -3}, {x, y, z}, {y, 0.3, 0.3}, {y, 0.3, -5}, {y, 0.9, 0.3}});
  const std::array<std::uint32_t, 3> rest{1, 2, 3};
  for (const auto& [i, j, k] : {std::array{0U, 1U, 2U}, {0U, 2U, 1U}, {1U, 2U, 0U}, {1U, 0U, 2U}})
    check_tier(Tier::filter, Sign::zero,
               [&, i = i, j = j, k = k] { return orient3d(walls.input, 0U, rest[i], rest[j], rest[k]); });
  CHECK(orient3d(walls.input, 0U, 1U, 2U, 4U) == Sign::positive);
  CHECK(orient3d(walls.input, 0U, 2U, 4U, 1U) == Sign::positive);
}

// Catches: exact steps asked too late, or never.
TEST_CASE("coplanar vertices of few bits take exact steps", "[kernel]") {
  const Given g({{0, 1e6, -1e6}, {1e6, -1e6, 0}, {-1e6, 0, 1e6}, {2, -1, -1}});
  const auto p = [&](std::uint32_t v) { return g.point(SymbolicPoint::input(v)); };
  check_tier(Tier::steps, Sign::zero, [&] { return orient3d(g.input, 0U, 1U, 2U, 3U); });
  check_tier(Tier::steps, Sign::zero, [&] { return orient3d(g.input, p(0), p(1), p(2), p(3)); });
  check_tier(Tier::steps, Sign::zero, [&] { return orient3d(g.points[0], g.points[1], g.points[2], g.points[3]); });
}

// Both differences from the first vertex round to the same double. Catches: equal differences taken for equal points.
TEST_CASE("points whose differences from a third round alike are told apart", "[kernel]") {
  const double up = std::nextafter(1.0, 2.0);
  const Given g({{-4, -4, 0}, {1, 1, 0}, {1, up, 0}, {-1.7e308, -1e308, 0}, {1.7e308, 1e308, 0}, {1.6e308, 1.1e308, 0}},
                {{0, 1, 2}, {3, 4, 5}});
  check_tier(Tier::double_double, Sign::positive, [&] { return normal_component(g.input, 0, 2); });
  CHECK(normal_component(g.input, 1, 2) == Sign::positive);
}

// 3 b' + 8 bits on a lattice of b' = b + 1 bits. Catches: a tier taken too early, or one that is never taken.
TEST_CASE("coplanar vertices take the narrowest integers that hold the determinant", "[kernel]") {
  const struct {
    int b;
    Tier tier;
  } cases[] = {{0, Tier::bits_128},    {39, Tier::bits_128},   {40, Tier::bits_256},   {81, Tier::bits_256},
               {82, Tier::bits_512},   {167, Tier::bits_512},  {168, Tier::bits_1024}, {337, Tier::bits_1024},
               {338, Tier::bits_4096}, {1000, Tier::bits_4096}};
  for (const auto& [b, tier] : cases) {
    CAPTURE(b);
    const Given g = coplanar(b);
    check_tier(tier, Sign::zero, [&] { return orient3d(g.input, 0U, 1U, 2U, 3U); });
  }
}

TEST_CASE("a construction is on its own face by name", "[kernel]") {
  const Given g({{0, 0, 0}, {3, 0, 1}, {0, 3, 1}, {1, 1, -5}, {1, 1, 5}}, {{0, 1, 2}});
  const Point p = g.point(SymbolicPoint::edge_face(3, 4, 0));
  check_tier(Tier::names, Sign::zero, [&] { return side_of_face(g.input, 0, p); });
  check_tier(Tier::names, Sign::zero, [&] { return compare(g.input, 2, p, p); });
}

// The line x = y = 1 meets the first plane in (1, 1, 2/3), where the second one passes too.
TEST_CASE("a construction on a plane it is not named for needs integers", "[kernel][degenerate]") {
  const Given g({{0, 0, 0}, {3, 0, 1}, {0, 3, 1}, {1, 1, -5}, {1, 1, 5}, {3, 0, 0}, {0, 3, 0}, {0, 0, 2}},
                {{0, 1, 2}, {5, 6, 7}});
  const Point p = g.point(SymbolicPoint::edge_face(3, 4, 0));
  CHECK(exact_position(g.input, p) == RationalPoint{1, 1, Rational(2, 3)});
  check_tier(Tier::bits_128, Sign::zero, [&] { return side_of_face(g.input, 1, p); });
}

// Four planes through (1, 1, 1), none along an axis: 9 b + 20 bits with b = 3.
TEST_CASE("four planes through one point meet in it under every name", "[kernel][degenerate]") {
  const Given g({{2, 0, 0},
                 {0, 2, 0},
                 {2, 0, 4},
                 {0, 2, 0},
                 {0, 0, 2},
                 {4, 2, 0},
                 {2, 0, 0},
                 {0, 0, 2},
                 {2, 4, 0},
                 {3, 0, 0},
                 {0, 3, 0},
                 {0, 0, 3}},
                {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}});
  const Point p = g.point(SymbolicPoint::three_faces(0, 1, 2)), q = g.point(SymbolicPoint::three_faces(1, 2, 3));
  check_tier(Tier::bits_128, Sign::zero, [&] { return side_of_face(g.input, 3, p); });
  check_tier(Tier::names, Sign::zero, [&] { return side_of_face(g.input, 3, q); });
  CHECK(p.name != q.name);
  CHECK(equal(g.input, p, q));
}

TEST_CASE("1e-300 beside 1e300 needs unbounded integers", "[kernel]") {
  const Given g({{1e-300, 0, 0}, {0, 1e-300, 0}, {1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}});
  const Given flat({{1e-300, 0, 1e-300}, {0, 1e-300, 0}, {1e300, 1e300, 1e300}, {-1e300, 2e300, -1e300}});
  check_tier(Tier::unbounded, Sign::zero, [&] { return orient3d(flat.input, 0U, 1U, 2U, 3U); });
  CHECK(orient3d(g.input, 0U, 1U, 2U, 3U) == -orient3d(g.input, 1U, 0U, 2U, 3U));
  CHECK(orient3d(g.input, 0U, 1U, 2U, 3U) != Sign::zero);
}

TEST_CASE("subnormals and huge numbers alone need few bits, others none", "[kernel]") {
  for (const double unit : {std::numeric_limits<double>::denorm_min(), 1.0, 0x1p1021}) {
    CAPTURE(unit);
    const Given g({{unit, 0, unit}, {0, unit, 0}, {-unit, 0, -unit}, {2 * unit, -unit, 2 * unit}, {0, 0, -2 * unit}});
    const Tier tier = unit == 1.0 ? Tier::steps : Tier::bits_128;
    check_tier(tier, Sign::zero, [&] { return orient3d(g.input, 0U, 1U, 2U, 3U); });
    CHECK(orient3d(g.input, 0U, 1U, 2U, 4U) == Sign::negative);
  }
}

TEST_CASE("a rational vertex needs long integers where the filter does not know", "[kernel]") {
  const std::vector<InputComplex::Coordinates> points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
  const std::vector<ExactVertex> exact{{3, {Rational(1, 3), Rational(1, 3), Rational(1, 3)}}};
  InputComplex doubles, rationals;
  doubles.add(points, {});
  rationals.add(points, {}, exact);
  check_tier(Tier::bits_4096, Sign::zero, [&] { return orient3d(rationals, 0U, 1U, 2U, 3U); });
  CHECK(orient3d(doubles, 0U, 1U, 2U, 3U) == Sign::negative);  // the double next to 1/3 lies below it
}

// Catches: a remainder that is not added, or one left out of the lattice.
TEST_CASE("a vertex that is the sum of two doubles needs no more bits than these", "[kernel]") {
  const double least = 0x1p-60;
  const std::vector<InputComplex::Coordinates> points{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}};
  const Rational above = to_rational(1) + to_rational(least), below = to_rational(1) - to_rational(least);
  InputComplex flat, lower;
  const std::vector<ExactVertex> in_plane{{3, {above, below, 0}}}, under_plane{{3, {below, 1, 0}}};
  flat.add(points, {}, in_plane);
  lower.add(points, {}, under_plane);
  check_tier(Tier::bits_256, Sign::zero, [&] { return orient3d(flat, 0U, 1U, 2U, 3U); });
  check_tier(Tier::double_double, Sign::negative, [&] { return orient3d(lower, 0U, 1U, 2U, 3U); });
}

// Catches: coordinates taken for equal whose nearest doubles are, what is left of a sum that is forgotten by a meet.
TEST_CASE("coordinates in common need no integers, even as sums of two doubles", "[kernel]") {
  const double least = 0x1p-60;
  const Rational sum = to_rational(1) + to_rational(least), less = to_rational(1) - to_rational(least);
  const auto rational = [](double x) { return to_rational(x); };
  // All in the plane z = 1 + 2^-60 but the fifth, which is 2^-59 below it; edges 0 1 and 2 3 cross.
  const std::vector<InputComplex::Coordinates> points{{0.1, 0.3, 1}, {0.7, 0.9, 1}, {0.1, 0.7, 1}, {0.9, 0.3, 1},
                                                      {0.3, 0.1, 1}, {0.7, 0.3, 0}, {0.7, 0.3, 2}, {0.2, 0.7, 1}};
  std::vector<ExactVertex> exact;
  for (const std::uint32_t v : {0U, 1U, 2U, 3U, 4U, 7U})
    exact.push_back({v, {rational(points[v][0]), rational(points[v][1]), v == 4 ? less : sum}});
  const std::vector<InputComplex::Indices> faces{{0, 3, 1}};
  InputComplex input;
  input.add(points, faces, exact);
  check_tier(Tier::double_double, Sign::zero, [&] { return orient3d(input, 0U, 1U, 2U, 3U); });
  CHECK(orient3d(input, 0U, 3U, 1U, 4U) == Sign::negative);
  CHECK(orient3d(input, 0U, 1U, 3U, 4U) == Sign::positive);
  const Point meet = make_point(input, SymbolicPoint::edge_edge(0, 1, 2, 3));
  const Point in_face = make_point(input, SymbolicPoint::edge_face(5, 6, 0));
  for (const Point& p : {meet, in_face}) {
    CHECK(exact_position(input, p)[2] == sum);
    CHECK(to_rational(p.fine[2].value) + to_rational(p.fine[2].low) == sum);
    CHECK(p.fine[2].error == 0);
  }
  // Seen along y: the points at one height are in line, the fifth is not.
  const Projection projection{.u = 2, .v = 0};
  const Point at[] = {make_point(input, SymbolicPoint::input(0)), make_point(input, SymbolicPoint::input(4))};
  check_tier(Tier::double_double, Sign::zero, [&] { return orient2d(input, projection, at[0], meet, in_face); });
  CHECK(orient2d(input, projection, at[0], meet, at[1]) != Sign::zero);
}

// Lines in a plane x = 0, so far apart in size that no long integer holds their meet: the axis along which they do not
// meet must not be taken for the answer. Catches: the sign of a lost value that is read.
TEST_CASE("a meet of edges that no long integer holds is found by unbounded ones", "[kernel][degenerate]") {
  for (const double far : {1.0, 0x1p900, 0x1p974, 0x1p1020})
    for (const double near : {0x1p-1000, 0x1p-1060, 0x1p-1074})
      for (int orientations = 0; orientations < 3; ++orientations) {
        CAPTURE(far, near, orientations);
        std::vector<InputComplex::Coordinates> points{
            {0, -far, -far}, {0, far, far}, {0, -far, near}, {0, far, 0}, {0, 0, 0}};
        for (auto& p : points) std::rotate(p.begin(), p.begin() + orientations, p.end());
        InputComplex input;
        input.add(points, {});
        const Point meet = make_point(input, SymbolicPoint::edge_edge(0, 1, 2, 3));
        const Point origin = make_point(input, SymbolicPoint::input(4));
        const RationalPoint place = exact_position(input, meet);
        for (int axis = 0; axis < 3; ++axis)
          CHECK(compare(input, axis, meet, origin) == static_cast<Sign>(place[static_cast<std::size_t>(axis)].sign()));
        CHECK_FALSE(equal(input, meet, origin));
      }
}
