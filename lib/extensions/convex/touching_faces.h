#pragma once
#include "extensions/convex/surface.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata::convex {

/// A superset of the faces of the boundary of A + B: all triangles of sums of points of both boundaries in which the
/// two may touch from outside without crossing nearby. Just behind each of them is the interior of A + B. They may
/// cross, touch and coincide, and are no closed surface; theory.md, "Minkowski sums".
///
/// For the boundary of a solid and that of a solid or of a polytope of any dimension. The lattice of each operand
/// determines the integers used. Throws Cancelled, std::overflow_error where a sum is beyond all doubles. O(n m) signs,
/// most of them in doubles, for n and m edges; O(n + m + triangles) memory and n m bits.
[[nodiscard]] ExactMesh touching_faces(const Surface& a, const Surface& b, const Monitor& monitor = {});

}  // namespace strata::convex
