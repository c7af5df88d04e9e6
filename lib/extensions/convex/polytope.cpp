#include "strata/convex.h"

namespace strata::convex {

RationalPoint Polytope::position(std::uint32_t vertex) const {
  return ExactMeshView(MeshView(vertices, {}), exact).position(vertex);
}

ExactMesh mesh_of(const Polytope& polytope) {
  ExactMesh result;
  if (polytope.dimension < 3) return result;
  result.mesh.vertices = polytope.vertices;
  result.exact = polytope.exact;
  for (const std::vector<std::uint32_t>& loop : polytope.facets)
    for (std::size_t i = 2; i < loop.size(); ++i) result.mesh.triangles.push_back({loop[0], loop[i - 1], loop[i]});
  return result;
}

}  // namespace strata::convex
