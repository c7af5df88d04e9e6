#include <catch2/catch.hpp>

#include "strata/strata.h"
#include "support/append.h"
#include "support/touching.h"

using namespace strata;

namespace {

/// Several closed meshes as one that crosses itself.
Mesh joined(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& m : meshes) test::append(all, m);
  return all;
}

Solid united(const std::vector<Mesh>& meshes) {
  std::vector<Solid> solids;
  for (const Mesh& m : meshes) solids.emplace_back(m);
  return union_(solids);
}

}  // namespace

// Two ways through the engine: pairs within one operand, winding numbers above 1; and pairs of operands.
TEST_CASE("a mesh that crosses itself is the union of its parts", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_pair(seed);
    REQUIRE(Solid(joined(operands.meshes), InputClass::overlapping) == united(operands.meshes));
  }
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_operands(seed);
    REQUIRE(Solid(joined(operands.meshes), InputClass::overlapping) == united(operands.meshes));
  }
}

TEST_CASE("meshes that cross themselves are operands like their unions", "[csg][property]") {
  for (std::uint64_t seed = 500; seed < 540; ++seed) {
    CAPTURE(seed);
    const auto a = test::touching_pair(seed), b = test::touching_pair(seed + 1000);
    const Mesh first = joined(a.meshes), second = joined(b.meshes);
    const std::vector<MeshView> views{first, second};
    for (const Operation op : all_operations) {
      BooleanResult r =
          combine(op, std::span<const MeshView>(views), {.input = InputClass::overlapping, .exact_vertices = true});
      const Solid operands[] = {united(a.meshes), united(b.meshes)};
      REQUIRE(canonical_form(ExactMesh{std::move(r.mesh), std::move(r.exact)}) ==
              combine_solids(op, operands).canonical());
    }
  }
}

// Edge 0-2 of the first tetrahedron lies in face 4, of the second. Two layers without volume divide it: one crosses
// it, the other touches it where one of its own edges passes through face 4. Only faces of that layer know that point
// by both its names, edge in edge and edge in face 4, and nothing is kept of them.
TEST_CASE("layers that vanish divide an edge alike in all faces", "[csg]") {
  const Mesh first{{{0, 0, 0}, {4, -1, 2}, {8, 0, 0}, {4, 1, 2}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Mesh second{{{-10, -10, 0}, {-10, 30, 0}, {30, -10, 0}, {0, 0, -20}},
                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Mesh touching{{{4, -3, -1}, {4, 3, 1}, {7, 0, -1}}, {{0, 1, 2}, {0, 2, 1}}};
  const Mesh crossing{{{2, -1, -1}, {2, 1, -1}, {2, 0, 3}}, {{0, 1, 2}, {0, 2, 1}}};
  const Solid expected = united({first, second});
  CHECK(Solid(joined({first, second, touching, crossing}), InputClass::overlapping) == expected);
  CHECK(Solid(joined({first, second, touching}), InputClass::overlapping) == expected);
  CHECK(Solid(joined({first, second, crossing}), InputClass::overlapping) == expected);
  CHECK(Solid(joined({crossing, touching, second, first}), InputClass::overlapping) == expected);
}

// The same, where each layer is two equal solids in an odd number of which nothing is.
TEST_CASE("solids that vanish divide an edge alike in all faces", "[csg]") {
  const std::vector<Triangle> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Solid first(Mesh{{{0, 0, 0}, {4, -1, 2}, {8, 0, 0}, {4, 1, 2}}, faces});
  const Solid second(Mesh{{{-10, -10, 0}, {-10, 30, 0}, {30, -10, 0}, {0, 0, -20}}, faces});
  const Solid touching(Mesh{{{4, -3, -1}, {4, 3, 1}, {7, 0, -1}, {6, -3, -4}}, faces});
  const Solid crossing(Mesh{{{2, -1, -1}, {2, 1, -1}, {2, 0, 3}, {3, 0, -1}}, faces});
  const Solid expected = first | second;
  CHECK(symmetric_difference({first, second, touching, touching, crossing, crossing}) == expected);
  CHECK(symmetric_difference({crossing, touching, second, first, touching, crossing}) == expected);
}
