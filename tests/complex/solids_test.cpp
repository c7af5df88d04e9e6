#include <catch2/catch.hpp>

#include "strata/complex.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::complex {

TEST_CASE("regularized sets are what the engine of regular solids makes", "[complex][property]") {
  // Two engines: one overlay with marks, and one that keeps boundaries by winding numbers.
  for (std::uint64_t seed = 0; seed < test::rounds(150); ++seed) {
    const test::Operands operands = test::touching_pair(seed);
    CAPTURE(seed, operands.kind);
    const Solid a(operands.meshes[0]), b(operands.meshes[1]);
    const SelectiveComplex s = of_solid(a), t = of_solid(b);
    REQUIRE(volume(s) == a.volume());
    REQUIRE(of_solid(a | b) == (s | t));
    REQUIRE(of_solid(a & b) == regularized(s & t));
    REQUIRE(of_solid(a - b) == regularized(s - t));
    REQUIRE(of_solid(a ^ b) == regularized(s ^ t));
    REQUIRE(of_solid(a - b, Border::open) == interior(of_solid(a, Border::open) - t));
    REQUIRE(open_regularized(s & t) == of_solid(a & b, Border::open));
  }
}

TEST_CASE("several solids are overlaid at once", "[complex][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(40); ++seed) {
    const test::Operands operands = test::touching_operands(seed);
    CAPTURE(seed, operands.kind);
    std::vector<Solid> solids;
    std::vector<SelectiveComplex> sets;
    for (const Mesh& m : operands.meshes) {
      solids.emplace_back(m);
      sets.push_back(of_solid(solids.back()));
    }
    REQUIRE(union_(sets) == of_solid(union_(solids)));
    SelectiveComplex odd = sets.front();
    for (std::size_t i = 1; i < sets.size(); ++i) odd = odd ^ sets[i];
    REQUIRE(regularized(odd) == of_solid(symmetric_difference(solids)));
  }
}

TEST_CASE("chains of operations stay exact", "[complex]") {
  // Vertices of results are rationals that meet the next operand.
  SelectiveComplex s = of_solid(Solid(test::icosphere({0, 0, 0}, 1, 1)));
  Solid expected(test::icosphere({0, 0, 0}, 1, 1));
  for (int i = 0; i < 6; ++i) {
    const Solid tool(test::icosphere({0.3 * i - 0.7, 0.1 * i, 0.2}, 0.6, 1));
    s = i % 2 == 0 ? s - of_solid(tool, Border::open) : s | of_solid(tool);
    expected = i % 2 == 0 ? expected - tool : expected | tool;
  }
  CHECK(regularized(s) == of_solid(expected));
  CHECK(volume(s) == expected.volume());
}

TEST_CASE("a grid of closed cubes is one box, and of open ones as many components", "[complex]") {
  std::vector<SelectiveComplex> closed, open;
  for (int i = 0; i < 27; ++i) {
    const Vertex low{1. * (i % 3), 1. * (i / 3 % 3), 1. * (i / 9)};
    const Solid cube(test::box(low, {low[0] + 1, low[1] + 1, low[2] + 1}));
    closed.push_back(of_solid(cube));
    open.push_back(of_solid(cube, Border::open));
  }
  const SelectiveComplex whole = of_solid(Solid(test::box({0, 0, 0}, {3, 3, 3})));
  CHECK(union_(closed) == whole);
  const SelectiveComplex parts = union_(open);
  CHECK(components(parts).count == 27);
  CHECK(part(parts, Part::cut) == interior(whole) - parts);
  CHECK(parts.count(2) == 27 * 6 - 54);  // inner faces once, outer ones
  CHECK(regularized(parts) == whole);
}

}  // namespace strata::complex
