#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "strata/check.h"
#include "strata/incremental.h"
#include "strata/transform.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

using namespace strata;
using test::Random;

namespace {

constexpr Operation operations[] = {Operation::union_, Operation::difference, Operation::symmetric_difference,
                                    Operation::intersection};

Solid combined(Operation operation, const Solid& a, const Solid& b) {
  const Solid both[] = {a, b};
  return combine_solids(operation, both);
}

/// Bits of the largest numerator and denominator of any coordinate.
std::size_t bits_of(const Solid& solid) {
  std::size_t most = 0;
  for (const ExactVertex& e : solid.exact_mesh().exact)
    for (const Rational& x : e.position)
      for (const Integer& n : {abs(numerator(x)), denominator(x)}) most = std::max(most, bit_length(n + 1) - 1);
  return most;
}

/// Every operation but the intersection, which leaves little, once in a while.
Operation pick_operation(Random& random) { return random.once_in(12) ? operations[3] : operations[random.below(3)]; }

/// Runs a chain both ways; after every step both must be the same solid.
void check_chain(const std::vector<std::pair<Operation, Solid>>& steps) {
  IncrementalSolid solid_in_steps;
  Solid solid;
  std::vector<std::pair<IncrementalSolid, Solid>> versions;
  for (const auto& [operation, tool] : steps) {
    CAPTURE(versions.size());
    solid_in_steps = solid_in_steps.with(operation, tool);
    solid = combined(operation, solid, tool);
    REQUIRE(solid_in_steps.solid() == solid);
    REQUIRE(solid_in_steps.volume() == Approx(to_nearest_double(solid.volume())).margin(1e-12));
    REQUIRE(solid_in_steps.is_empty() == solid.is_empty());
    if (!solid.is_empty()) REQUIRE(check(solid_in_steps.solid().exact_mesh()).empty());
    versions.emplace_back(solid_in_steps, solid);
  }
  for (const auto& [then, what] : versions) REQUIRE(then.solid() == what);
}

}  // namespace

TEST_CASE("chains of touching solids are what whole solids give", "[workpiece][property]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<std::pair<Operation, Solid>> steps{{Operation::union_, Solid(test::lattice_solid(random))}};
    for (int i = 0; i < 12; ++i) steps.emplace_back(pick_operation(random), Solid(test::lattice_solid(random)));
    check_chain(steps);
  }
}

TEST_CASE("chains of solids in general position", "[workpiece][property]") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto somewhere = [&] { return Vertex{random.unit(), random.unit(), random.unit()}; };
    std::vector<std::pair<Operation, Solid>> steps{{Operation::union_, Solid(test::icosphere({.5, .5, .5}, .6, 2))}};
    for (int i = 0; i < 9; ++i)
      steps.emplace_back(i % 3 == 2 ? Operation::union_ : Operation::difference,
                         Solid(test::icosphere(somewhere(), .1 + .2 * random.unit(), 1)));
    check_chain(steps);
  }
}

TEST_CASE("tools at rational places", "[workpiece][property]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<std::pair<Operation, Solid>> steps{{Operation::union_, Solid(test::lattice_solid(random))}};
    for (int i = 0; i < 8; ++i) {
      const auto third = [&] { return Rational(random.between(-4, 4), 3); };
      const Transform by =
          Transform::translation({third(), third(), third()}) * Transform::scaling({Rational(2, 3), Rational(4, 3), 1});
      const ExactMesh moved = transform(test::exact(test::lattice_solid(random)), by, Placement::exact);
      steps.emplace_back(pick_operation(random), Solid(moved));
    }
    check_chain(steps);
  }
}

TEST_CASE("many tools at once are the same as one after the other", "[workpiece][property]") {
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Solid start(test::lattice_solid(random));
    std::vector<Solid> tools;
    for (int i = 0; i < 7; ++i) tools.emplace_back(test::lattice_solid(random));
    for (const Operation operation : operations) {
      IncrementalSolid one(start);
      for (const Solid& tool : tools) one = one.with(operation, tool);
      CHECK(IncrementalSolid(start).with(operation, tools).solid() == one.solid());
    }
  }
}

TEST_CASE("the scales of tools may be far apart", "[workpiece]") {
  std::vector<std::pair<Operation, Solid>> steps{{Operation::union_, Solid(test::box({-1e30, -1, -1}, {1e30, 1, 1}))}};
  steps.emplace_back(Operation::difference, Solid(test::box({-1e-30, -2, -1e-30}, {1e-30, 2, 1e-30})));
  steps.emplace_back(Operation::union_, Solid(test::octahedron({0, 1, 0}, 1e-12)));
  steps.emplace_back(Operation::symmetric_difference,
                     Solid(test::tetrahedron({-5, -5, -5}, {7, -5, -5}, {-5, 9, -5}, {-5, -5, 1e30})));
  steps.emplace_back(Operation::difference, Solid(test::box({0, 0, 0}, {5e-324, 1, 1})));
  check_chain(steps);
}

TEST_CASE("coefficients and pieces do not grow with the number of steps", "[workpiece]") {
  // A wall that is cut a little lower by every tool, along planes that are never the same.
  IncrementalSolid solid_in_steps(Solid(test::box({0, 0, 0}, {8, 1, 8})));
  Random random(7);
  std::size_t triangles_after_50 = 0;
  for (int i = 0; i < 400; ++i) {
    const double top = 8 - .01 * i, x = 8 * random.unit();
    solid_in_steps =
        solid_in_steps.with(Operation::difference, Solid(test::octahedron({x, random.unit(), top + .3}, .7)));
    if (i == 50) triangles_after_50 = solid_in_steps.triangle_count();
  }
  const Solid solid = solid_in_steps.solid();
  constexpr std::size_t b = 56;         // coordinates up to 10 with the bits of numbers near .1
  CHECK(bits_of(solid) <= 9 * b + 14);  // three planes through vertices of tools
  CHECK(solid_in_steps.triangle_count() < 20 * triangles_after_50);
  // Every vertex but those of the block is one of the point set.
  CHECK(solid.mesh().vertices.size() <= solid.canonical().vertices.size() + 8);
}

TEST_CASE("what is added and taken away again leaves no trace", "[workpiece]") {
  const IncrementalSolid ball(Solid(test::icosphere({0, 0, 0}, 1, 2)));
  IncrementalSolid solid_in_steps = ball;
  for (int i = 0; i < 20; ++i) {
    const Solid tool(test::box({.1 * i, 1.5, -.1}, {.1 * i + .05, 2, .3}));
    solid_in_steps = solid_in_steps.with(Operation::union_, tool);
    solid_in_steps = solid_in_steps.with(Operation::difference, tool);
  }
  CHECK(solid_in_steps.solid() == ball.solid());
  CHECK(solid_in_steps.triangle_count() == ball.triangle_count());
}

TEST_CASE("empty workpieces and empty tools", "[workpiece]") {
  const Solid cube(test::box({0, 0, 0}, {1, 1, 1})), nothing;
  for (const Operation operation : operations) {
    CHECK(IncrementalSolid().with(operation, cube).solid() == combined(operation, nothing, cube));
    CHECK(IncrementalSolid(cube).with(operation, nothing).solid() == combined(operation, cube, nothing));
    CHECK(IncrementalSolid(cube).with(operation, cube).solid() == combined(operation, cube, cube));
    CHECK(IncrementalSolid().with(operation, nothing).is_empty());
  }
}

TEST_CASE("a step can be cancelled", "[workpiece]") {
  const IncrementalSolid cube(Solid(test::box({0, 0, 0}, {1, 1, 1})));
  CancelToken stop;
  stop.cancel();
  CHECK_THROWS_AS(cube.with(Operation::union_, Solid(test::box({0, 0, 0}, {2, 2, 2})), {.cancel = &stop}), Cancelled);
}

TEST_CASE("a chain that goes on from its exact mesh does not grow either", "[workpiece]") {
  Solid solid(test::icosphere({0, 0, 0}, 1, 2));
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Vertex at{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
    solid = IncrementalSolid(Solid(solid.exact_mesh()))
                .with(Operation::difference, Solid(test::octahedron(at, .3)))
                .solid();
  }
  CHECK(bits_of(solid) <= 9 * 56 + 14);
}

TEST_CASE("rational corners on edges of doubles, in common planes", "[workpiece][property]") {
  const Transform third = Transform::scaling({Rational(1, 3), Rational(1, 3), Rational(1, 3)});
  const auto triangle = [](std::array<std::array<double, 2>, 3> p) {  // counter-clockwise
    const double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    if (area < 0) std::swap(p[1], p[2]);
    return std::pair(p, area != 0);
  };
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto whole = [&] { return static_cast<double>(random.between(-4, 4)); };
    const auto [loop, is_wide] = triangle({{{whole(), whole()}, {whole(), whole()}, {whole(), whole()}}});
    // A third of the way along an edge, times three.
    const std::array<double, 2> on_edge{2 * loop[0][0] + loop[1][0], 2 * loop[0][1] + loop[1][1]};
    const auto [thrice, is_wide_too] = triangle({{on_edge, {3 * whole(), 3 * whole()}, {whole(), whole()}}});
    if (!is_wide || !is_wide_too) continue;
    const Solid a(test::prism(loop, 0, 1));
    const Solid b(transform(test::exact(test::prism(thrice, 0, 3)), third, Placement::exact));
    const Rational common = combined(Operation::intersection, a, b).volume();
    CHECK(combined(Operation::union_, a, b).volume() == a.volume() + b.volume() - common);
    CHECK(combined(Operation::difference, a, b).volume() == a.volume() - common);
    for (const Operation operation : operations)
      CHECK(IncrementalSolid(a).with(operation, b).solid() == combined(operation, a, b));
  }
}

TEST_CASE("chains of solids that list edges and vertices for each part that touches there", "[workpiece][property]") {
  const Solid edge_twice(
      Mesh{{{0, 1, 3}, {1, 1, 3}, {1, 1, 1}, {0, 2, 3}, {1, 2, 3}, {1, 2, 1}, {1, 1, 1}, {0, 2, 3}},
           {{0, 2, 1}, {3, 1, 2}, {3, 2, 0}, {3, 0, 1}, {4, 6, 5}, {7, 5, 6}, {7, 6, 4}, {7, 4, 5}}});
  const Solid tetrahedron(test::tetrahedron({1, 1, 2}, {1, 0, 0}, {1, 1, 0}, {0, 1, 2}));
  const Solid far(test::box({8, 8, 8}, {9, 9, 9})), block(test::box({-1, 1.5, 2}, {3, 4, 4}));
  for (const Operation operation : operations) {
    check_chain({{Operation::union_, edge_twice}, {operation, tetrahedron}});
    check_chain({{Operation::union_, far}, {Operation::union_, edge_twice}, {operation, block}});
  }
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<std::pair<Operation, Solid>> steps;
    for (int i = 0; i < 8; ++i) {
      const Solid two = Solid(test::lattice_solid(random)) ^ Solid(test::lattice_solid(random));
      steps.emplace_back(i == 0 ? Operation::union_ : pick_operation(random), two.separated());
    }
    check_chain(steps);
  }
}
