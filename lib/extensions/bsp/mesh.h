#pragma once
#include <cstdint>
#include <vector>

#include "extensions/bsp/partition.h"
#include "strata/measure.h"
#include "strata/mesh.h"

namespace strata::bsp {

/// The region that a closed mesh bounds, whose winding numbers are 0 and 1; a mesh turned inside out bounds all else.
/// Triangles without area do not count. Requires that the mesh does not cross itself (`check` tells).
/// Expected O(n log^2 n); `built` has the choice of cuts.
[[nodiscard]] Partition<3> partition_of(ExactMeshView mesh, const Monitor& monitor = {});

/// A mesh and the oriented planes of its triangles, each once.
struct BoundaryMesh {
  ExactMesh mesh;
  std::vector<CanonicalPlane> planes;
  std::vector<std::uint32_t> plane_of;  ///< per triangle
};

/// The boundary as a closed triangle mesh with outward normals: facets in one plane are merged and divided anew, and
/// every vertex on an edge is a corner of all triangles there. Vertices in lexicographic order, coordinates rounded to
/// nearest doubles, exact places beside them. O(n log n) beside `boundary()`.
/// Throws std::domain_error when the boundary is not bounded.
[[nodiscard]] BoundaryMesh boundary_mesh(const Partition<3>& region);
[[nodiscard]] ExactMesh exact_mesh_of(const Partition<3>& region);  ///< the mesh alone

/// The boundary's one description; `canonical_form` of the mesh.
[[nodiscard]] CanonicalForm canonical_form_of(const Partition<3>& region);

}  // namespace strata::bsp
