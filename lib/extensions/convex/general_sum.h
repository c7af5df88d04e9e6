#pragma once
#include "extensions/convex/surface.h"
#include "strata/convex.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/solid.h"

namespace strata::convex {

/// A solid that is not empty, and its boundary with neighbourhoods. Refers to both.
struct SolidSurface {
  const ExactMesh& mesh;
  const Surface& surface;
};

/// A + B for any two solids, or for a solid and a polytope of any dimension that is not empty: the faces in which they
/// may touch (touching_faces) are arranged, and the pieces on the outside (keep_outer_pieces) are the boundary.
/// theory.md, "Minkowski sums". Throws as minkowski_sum does.
[[nodiscard]] Solid general_sum(const SolidSurface& a, const SolidSurface& b, const Options& options);
[[nodiscard]] Solid general_sum(const SolidSurface& a, const Polytope& b, const Options& options);

}  // namespace strata::convex
