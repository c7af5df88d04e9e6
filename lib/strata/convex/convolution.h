#pragma once
#include <cstdint>
#include <vector>

#include "strata/convex/surface.h"
#include "strata/mesh/exact_mesh.h"
#include "strata/mesh/monitor.h"

namespace strata::convex {

/// The convolution of two boundaries: all sums of points of A and B that have an outward direction in common, as a
/// surface that may cross and touch itself.
struct Convolution {
  /// Closed as a chain of geometric sides (a side may be opposite to several in one line). Its winding numbers are 0
  /// outside A + B and positive just inside of nearly all of its boundary; theory.md, "Minkowski sums".
  ExactMesh surface;
  /// A flat part of one boundary that surrounds a hole may come to lie on a face of the other operand. Then winding
  /// numbers may vanish just inside of A + B, and no surface is made.
  bool has_rings = false;
};

/// Of the boundary of a solid and that of a solid or of a polytope of any dimension. The lattice of each operand
/// decides about the integers used. Throws Cancelled, std::overflow_error where a sum is beyond all doubles. O(n m)
/// signs, most of them in doubles, for n and m edges; O(n + m + pieces) memory but for n m bits.
[[nodiscard]] Convolution convolution(const Surface& a, const Surface& b, const Monitor& monitor = {});

}  // namespace strata::convex
