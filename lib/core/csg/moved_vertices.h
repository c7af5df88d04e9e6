#pragma once
#include "core/round/moving_mesh.h"
#include "core/round/wrong_faces.h"
#include "strata/rounding.h"

namespace strata {

/// Adds the vertices that may be off the exact boundary, and of these those that may be farther than `far`. A vertex
/// is as near as any of its triangles. O(n), in parallel.
void count_moved_vertices(const MovingMesh::Parts& rounded, double far, RoundingReport& report);

/// The same for a mesh as it was given: triangles that were not changed did not move. `region`: what was searched; it
/// has all triangles at vertices of changed ones. O(size of the region).
void count_moved_vertices(const MovingMesh& rounded, const ChangedRegion& region, double far, RoundingReport& report);

}  // namespace strata
