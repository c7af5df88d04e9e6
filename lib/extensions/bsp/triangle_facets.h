#pragma once
#include <vector>

#include "extensions/bsp/build.h"
#include "extensions/bsp/mesh_planes.h"

namespace strata::bsp {

/// The triangles of a mesh as facets, in their order; those of zero area are left out. Their planes are added to the
/// table, and as walls, through every side, a plane parallel to the axis nearest to the normal. Corners of a facet
/// follow those of its triangle: (0, 1, 2), or (0, 2, 1) if its normal points to the minus side. Expected O(n).
[[nodiscard]] std::vector<Facet<3>> triangle_facets(HyperplaneTable<3>& table, ExactMeshView mesh,
                                                    const Monitor& monitor = {});
[[nodiscard]] std::vector<Facet<3>> triangle_facets(MeshPlanes& planes, const Monitor& monitor = {});

}  // namespace strata::bsp
