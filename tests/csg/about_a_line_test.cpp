// Faces of several operands that cross in one line: an edge of the result where the faces that are left meet in it.
#include <catch2/catch.hpp>

#include "strata/check.h"
#include "strata/combine.h"
#include "strata/resolve.h"
#include "support/rounds.h"
#include "support/touching.h"

using namespace strata;

namespace {

/// All solids as one mesh, some of them reversed.
Mesh layers(const std::vector<Mesh>& solids, test::Random& random) {
  Mesh all;
  for (const Mesh& solid : solids) {
    const bool is_reversed = random.once_in(3);
    const auto shift = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), solid.vertices.begin(), solid.vertices.end());
    for (const Triangle& t : solid.triangles) {
      all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
      if (is_reversed) std::swap(all.triangles.back()[1], all.triangles.back()[2]);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("tetrahedra whose faces cross in one line have solids as results", "[csg]") {
  for (std::uint64_t seed = 0; seed < test::rounds(200); ++seed) {
    INFO("seed " << seed);
    test::Random random(seed);
    const std::vector<Mesh> solids = test::about_a_line(random).meshes;
    const std::vector<MeshView> views(solids.begin(), solids.end());
    for (const Operation operation :
         {Operation::union_, Operation::intersection, Operation::difference, Operation::symmetric_difference}) {
      const BooleanResult result = combine(operation, views, {.exact_vertices = true});
      if (!result.mesh.triangles.empty()) CHECK(check(ExactMesh{result.mesh, result.exact}).empty());
    }
    const Mesh mesh = layers(solids, random);
    for (const Inside inside : {Inside::even_odd, Inside::outer})
      CHECK(check(resolve({mesh, {}}, inside).exact_mesh()).empty());
  }
}
