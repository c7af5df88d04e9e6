#include <catch2/catch.hpp>

#include "strata/strata.h"
#include "support/touching.h"

using namespace strata;

namespace {

/// Several closed meshes as one that crosses itself.
Mesh joined(const std::vector<Mesh>& meshes) {
  Mesh all;
  for (const Mesh& m : meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), m.vertices.begin(), m.vertices.end());
    for (const Triangle& t : m.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
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
