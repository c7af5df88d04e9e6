#pragma once
#include <vector>

#include "extensions/bsp/build.h"
#include "extensions/bsp/mesh_planes.h"

namespace strata::bsp {

/// The triangles of a mesh as facets, in their order; those without area are left out. Their planes are added to the
/// table, and through every side a plane along the axis nearest to the normal, as a wall. Corners of a facet follow
/// those of its triangle: (0, 1, 2), or (0, 2, 1) where it does not face plus. Expected O(n).
[[nodiscard]] std::vector<Facet<3>> triangle_facets(HyperplaneTable<3>& table, ExactMeshView mesh);
[[nodiscard]] std::vector<Facet<3>> triangle_facets(MeshPlanes& planes);

}  // namespace strata::bsp
