#pragma once
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// True when a mesh is found to bound a solid that is starlike: from one point, the whole inner side of every face is
/// seen, and every direction meets one face. Such a mesh is closed, crosses itself nowhere, and has the winding numbers
/// 0 and 1. False when it does not, or when the point that is tried, near the middle of the box, or doubles do not show
/// it: no statement about the mesh. Any mesh. Runs in the current task arena.
///
/// Boxes, balls, cylinders, hulls and many turned parts are starlike, and need no search for intersections. O(n), one
/// pass over the faces; for most other meshes it ends at one of the first faces. Proof: theory.md, "Intersections of
/// one mesh with itself". Throws Cancelled.
[[nodiscard]] bool is_found_starlike(MeshView mesh, const Monitor& monitor);

}  // namespace strata
