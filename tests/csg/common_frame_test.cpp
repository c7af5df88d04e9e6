#include "core/csg/common_frame.h"

#include <catch2/catch.hpp>
#include <vector>

#include "strata/attributes.h"
#include "strata/expression.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::box;
using test::Random;

namespace {

Transform turn(double degrees) { return Transform::rotation(Quaternion::of_angle({1, 2, 3}, degrees)); }
Transform quarter() { return Transform::rotation(Quaternion::of_angle({0, 0, 1}, 90)); }
Transform shift(double x) { return Transform::translation({x, Rational(1, 3), 0}); }

std::optional<Transform> frame(const std::vector<std::pair<Transform, std::size_t>>& maps) {
  std::vector<PlacedVertices> placed;
  for (const auto& [map, count] : maps) placed.push_back({&map, count});
  return common_frame(placed);
}

/// Parts about the origin that touch, each under a random map of few digits, and what one step after the other gives.
struct Assembly {
  Expression expression;
  Solid solid;
};

Assembly random_assembly(Random& random) {
  std::optional<Assembly> whole;
  const auto operands = test::touching_operands(random.below(1000)).meshes;
  for (std::size_t i = 0; i < 5; ++i) {
    const Solid part(operands[i % operands.size()]);
    const Transform map = Transform::translation({random.between(-2, 2), random.between(-2, 2), 0}) *
                          (random.once_in(2) ? quarter() : Transform());
    const Expression placed = Expression(part, "p").transformed(map);
    const Solid moved = part.transformed(map);
    if (!whole)
      whole = {placed, moved};
    else if (random.once_in(3))
      whole = {whole->expression - placed, combine_solids(Operation::difference, std::vector{whole->solid, moved})};
    else
      whole = {whole->expression | placed, combine_solids(Operation::union_, std::vector{whole->solid, moved})};
  }
  return *whole;
}

}  // namespace

TEST_CASE("a frame is that of the rotation which most vertices have", "[csg]") {
  const Transform a = turn(20), b = turn(50);
  CHECK(frame({{shift(1) * a, 20}, {shift(2) * a * quarter(), 10}}) == shift(1) * a);
  CHECK(frame({{a, 1000}, {Transform(), 10}}) == a);
  CHECK(frame({{a, 10}, {b, 300}, {b * quarter(), 200}}) == b);
  CHECK(frame({{a, 100}, {Transform(), 100}}) == std::nullopt);  // the other would have to be turned back
  CHECK(frame({{a, 100}, {b, 100}}) == std::nullopt);
  CHECK(frame({{shift(1), 10}, {shift(2) * quarter(), 10}}) == std::nullopt);  // nothing is to be gained
  CHECK(frame({}) == std::nullopt);
  std::vector<std::pair<Transform, std::size_t>> many;
  for (int i = 1; i < 100; ++i) many.emplace_back(turn(i), 1);
  CHECK(frame(many) == std::nullopt);
}

// Catches: the wrong order of maps, mirrored maps, results that are not moved back, sources that are lost.
TEST_CASE("solids that are moved as a whole give what they give one by one", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(20); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Assembly assembly = random_assembly(random);
    Transform map = Transform::translation({0.1, 0.2, 0.3}) * turn(random.unit() * 360);
    if (random.once_in(2)) map = map * Transform::scaling({-1, Rational(1, 3), 1});
    const Solid knife(box({0.1, -9, -9}, {9, 9, 9}));
    const Solid moved = assembly.expression.transformed(map).evaluate();
    CHECK(moved == assembly.solid.transformed(map));
    CHECK((assembly.expression.transformed(map) - Expression(knife, "k")).evaluate() ==
          assembly.solid.transformed(map) - knife);
    CHECK((Expression(knife, "k") - assembly.expression.transformed(map)).evaluate() ==
          knife - assembly.solid.transformed(map));
  }
}

TEST_CASE("every triangle of a moved result names its solid", "[csg]") {
  const Expression cross = Expression(Solid(box({-3, -1, -1}, {3, 1, 1})), "a").transformed(shift(0.1)) |
                           Expression(Solid(box({-1, -3, -2}, {1, 3, 2})), "b");
  const Solid solid = cross.transformed(turn(30)).evaluate();
  const std::size_t of_a = static_cast<std::size_t>(
      std::count_if(solid.sources().begin(), solid.sources().end(), [](const Source& s) { return s.operand == 0; }));
  CHECK(of_a > 0);
  CHECK(of_a < solid.sources().size());
  const Solid before = cross.evaluate();
  CHECK(solid.sources() == before.sources());
}

TEST_CASE("solids are combined where they are if the other place is beyond all doubles, or is rounded", "[csg]") {
  const Transform tiny = turn(30) * Transform::scaling(RationalPoint{1e-300, 1e-300, 1e-300});
  const Expression small = Expression(Solid(box({0, 0, 0}, {1, 1, 1})), "a").transformed(tiny) |
                           Expression(Solid(box({2, 0, 0}, {3, 1, 1})), "b").transformed(tiny),
                   large(Solid(test::octahedron({1e12, 0, 0}, 5)), "c");
  std::vector<Expression> terms(20, small);
  CHECK((Expression::any(terms) | large).evaluate().volume() == small.evaluate().volume() + large.evaluate().volume());

  const Solid part(box({0, 0, 0}, {1, 1, 1}));
  const Expression rounded = Expression(part, "a").transformed(turn(30), Placement::rounded);
  CHECK(rounded.evaluate() == part.transformed(turn(30), Placement::rounded));
}
