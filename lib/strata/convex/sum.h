#pragma once
#include "strata/convex/polytope.h"

namespace strata::convex {

/// The Minkowski sum {x + y : x in a, y in b} of two polytopes of any dimensions; nothing if one of them is.
/// Laws: commutative, associative, exact for all finite input. Throws std::overflow_error where a coordinate of the sum
/// is beyond all doubles. Facets come from overlaying the Gauss maps: O(n m) signs, most of them in doubles, for n and
/// m edges; the rest is O(n log n + m log m + size of the sum). Source: overlay of normal fans (Fogel and Halperin
/// 2007); theory.md, "Minkowski sums".
[[nodiscard]] Polytope sum(const Polytope& a, const Polytope& b);

}  // namespace strata::convex
