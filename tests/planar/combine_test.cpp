#include <catch2/catch.hpp>
#include <cmath>

#include "planar/shapes.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

using namespace test;

Loops random_operand(Random& random, unsigned seed) {
  const int grid = 2 + static_cast<int>(seed % 5);
  switch (seed % 8) {
    case 0:
      return in_thirds(random_grid_loops(random, grid));
    case 1:
      return loops(random_grid_loops(random, grid, 0x1p-1074));
    case 2:
      return loops(random_grid_loops(random, grid, 0x1p1020));
    default:
      return loops(random_grid_loops(random, grid));
  }
}

bool same(const Region& a, const Region& b) { return canonical_form(a) == canonical_form(b); }

/// All that is listed, in its order.
struct Listed {
  std::vector<std::uint32_t> first_loop, first_vertex;
  std::vector<RationalPlacement> corners;
  friend bool operator==(const Listed&, const Listed&) = default;
};
Listed listed(const Region& r) {
  Listed all{r.first_loop, r.loops.first_vertex, {}};
  for (const std::uint32_t v : r.loops.vertices) all.corners.push_back(exact_position(r.loops.places, v));
  return all;
}

}  // namespace

TEST_CASE("two squares, combined", "[planar][combine]") {
  const Loops a = square(0, 0, 2), b = square(1, 1, 2);
  CHECK(area(union_(a, b)) == 7);
  CHECK(area(intersection(a, b)) == 1);
  CHECK(area(difference(a, b)) == 3);
  const Region both = symmetric_difference(a, b);
  CHECK(area(both) == 6);
  CHECK(both.polygons() == 2);
  CHECK(union_(a, b).loops.vertices.size() == 8);
}

TEST_CASE("squares side by side are united without a cut", "[planar][combine][degenerate]") {
  const Region r = union_(square(0, 0), square(1, 0));
  CHECK(r.polygons() == 1);
  CHECK(r.loops.vertices.size() == 4);
  CHECK(intersection(square(0, 0), square(1, 0)).empty());
}

TEST_CASE("two squares in checkerboard contact stay two polygons that share a vertex",
          "[planar][combine][degenerate]") {
  const Region r = union_(square(0, 0), square(1, 1));
  REQUIRE(r.polygons() == 2);
  CHECK(validate(r).empty());
  CHECK(r.loops.vertices[2] == r.loops.vertices[4]);
}

// Catches: holes, or polygons, that start in one point in an order of their own.
TEST_CASE("the order of what is listed depends on the set alone", "[planar][combine][degenerate]") {
  const Loop around = box(0, 0, 10, 10), low{{2, 5}, {5, 4}, {5, 2}}, high{{2, 5}, {5, 8}, {5, 6}};
  const Region holes = fill({loops({around, low, high}), FillRule::even_odd});
  CHECK(holes.holes(0) == 2);
  CHECK(listed(holes) == listed(fill({loops({high, around, low}), FillRule::even_odd})));
  const Region tips = union_(loops({low}), loops({high}));
  CHECK(tips.polygons() == 2);
  CHECK(listed(tips) == listed(union_(loops({high}), loops({low}))));
  for (unsigned seed = 0; seed < seeds(1000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Loops a = random_operand(random, seed), b = random_operand(random, seed);
    const Region r = symmetric_difference(a, b);
    CHECK(listed(r) == listed(symmetric_difference(b, a)));
    CHECK(listed(r) == listed(fill(r)));
  }
}

// Catches: a meet whose place comes out as infinite, since what it is divided by vanished, taken for well known.
TEST_CASE("meets of rationals below all doubles are found", "[planar][combine][degenerate]") {
  const Rational unit = to_rational(0x1p-1074) / 3;
  const auto narrow = [&](const Loop& loop) {
    LoopsBuilder builder;
    for (const PlanePoint& p : loop) builder.add_vertex(RationalPlacement{to_rational(p[0]) * unit, to_rational(p[1])});
    builder.end_loop();
    return builder.finish();
  };
  const Loop a{{1, 1}, {8, 7}, {1, 2}, {5, 6}, {1, 0}}, b{{6, 5}, {6, -4}, {2, 2}};
  for (const auto combined : {&union_, &intersection}) {
    const Loops narrow_a = narrow(a), narrow_b = narrow(b), wide_a = loops({a}), wide_b = loops({b});
    CHECK(area(combined(narrow_a, narrow_b)) == area(combined(wide_a, wide_b)) * unit);
  }
}

TEST_CASE("zeros of results have no sign", "[planar][combine][degenerate]") {
  const Region r = union_(loops({{{-0.0, -0.0}, {2, -0.0}, {-0.0, 2}}}), loops({box(-1, -1, -0.0, 1)}));
  for (const PlanePoint& p : r.loops.places.place)
    for (const double x : p) CHECK_FALSE((x == 0 && std::signbit(x)));
  CHECK(area(r) == 4);
}

TEST_CASE("a hole and an island in it", "[planar][combine]") {
  const std::vector<Operand> operands;
  const Loops ring = loops({box(0, 0, 9, 9), box(1, 1, 8, 8), box(2, 2, 7, 7), box(3, 3, 6, 6)});
  const Region r = fill({ring, FillRule::even_odd});
  REQUIRE(r.polygons() == 2);
  CHECK(r.holes(0) == 1);
  CHECK(r.holes(1) == 1);
  CHECK(area(r, 0) == 81 - 49);
  CHECK(area(r, 1) == 25 - 9);
  CHECK(fill(ring).polygons() == 1);
  CHECK(fill(ring).loops.size() == 1);
}

TEST_CASE("a combination that holds everywhere outside is refused", "[planar][combine]") {
  const Loops a = square(0, 0);
  const std::vector<Operand> operands{a};
  CHECK_THROWS_AS(combine(operands, [](const Inside& inside) { return inside.count == 0; }), UnboundedResult);
}

// Catches: sectors linked wrongly, overlaps counted wrongly, holes and islands in the wrong face, corners lost.
TEST_CASE("membership in a result is the combination of memberships", "[planar][combine][property]") {
  const auto seed = GENERATE(range(0u, seeds(600)));
  CAPTURE(seed);
  Random random(seed);
  const Loops a = random_operand(random, seed), b = random_operand(random, seed);
  const double unit = seed % 8 == 1 ? 0x1p-1074 : seed % 8 == 2 ? 0x1p1020 : 1;
  const FillRule fill = seed % 3 == 0 ? FillRule::nonzero : seed % 3 == 1 ? FillRule::even_odd : FillRule::positive;
  for (const Operation operation :
       {Operation::union_, Operation::intersection, Operation::difference, Operation::symmetric_difference}) {
    CAPTURE(static_cast<int>(operation));
    const Region r = combine(std::vector<Operand>{{a, fill}, {b, fill}}, operation);
    const auto broken = validate(r);
    CHECK(broken == std::vector<std::string>{});
    const Locator locator(r);
    Rational covered = 0;
    for (int i = -1; i < 16; ++i) {  // off all edges: edges have slopes of small numbers
      const RationalPlacement p{to_rational(unit) * (Rational(i, 2) + Rational(1, 1009)),
                                to_rational(unit) * (Rational(i * 7 % 16, 2) + Rational(1, 10007))};
      Inside inside{{is_filled(fill, winding(a, p)), is_filled(fill, winding(b, p))}, 0};
      inside.count = inside.is_in[0] + inside.is_in[1];
      const Membership expected = holds(operation, inside) ? Membership::in : Membership::out;
      CHECK(locator.locate(p) == expected);
      CHECK((winding(r.loops, p) == 1) == (expected == Membership::in));
    }
  }
}

// Catches: meets or lines lost on the way from one operation to the next.
TEST_CASE("Boolean laws hold for results of results", "[planar][combine][property]") {
  const auto seed = GENERATE(range(0u, seeds(400)));
  CAPTURE(seed);
  Random random(seed);
  const Region a = fill(random_operand(random, seed)), b = fill(random_operand(random, seed));
  const Region both = union_(a, b), common = intersection(a, b), either = symmetric_difference(a, b);
  CHECK(area(a) + area(b) == area(both) + area(common));
  CHECK(area(either) == area(both) - area(common));
  CHECK(same(either, difference(both, common)));
  CHECK(same(both, union_(b, a)));
  CHECK(same(common, intersection(b, a)));
  CHECK(same(union_(a, a), a));
  CHECK(same(intersection(a, a), a));
  CHECK(difference(a, a).empty());
  CHECK(same(difference(a, b), difference(a, common)));
  CHECK(same(union_(difference(a, b), common), a));
  // De Morgan inside a frame.
  const double far = 0x1p1023;
  const Loops frame = loops({box(-far, -far, far, far)});
  CHECK(same(difference(frame, both), intersection(difference(frame, a), difference(frame, b))));
  CHECK(same(difference(frame, common), union_(difference(frame, a), difference(frame, b))));
  CHECK(validate(either).empty());
}

}  // namespace strata::planar
