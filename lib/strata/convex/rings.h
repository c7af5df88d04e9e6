#pragma once
#include "strata/convex/directions.h"
#include "strata/convex/surface.h"

namespace strata::convex {

/// A ring is a flat part of a surface from which nothing near rises, and that surrounds holes. Is there one that faces
/// as some face of the other surface does, with a hole that may fit into a flat part of the other one? Where not, all
/// that both have in common when they touch is without holes; theory.md, "Minkowski sums".
/// Certain where the answer is no. O(n m) signs for n edges and m faces, most of them in doubles.
template <class N>
[[nodiscard]] bool has_rings(const Surface& surface, const Directions<N>& directions, const Surface& other,
                             const Directions<N>& of_other);

extern template bool has_rings(const Surface&, const Directions<__int128>&, const Surface&,
                               const Directions<__int128>&);
extern template bool has_rings(const Surface&, const Directions<WideInt<4>>&, const Surface&,
                               const Directions<WideInt<4>>&);
extern template bool has_rings(const Surface&, const Directions<Integer>&, const Surface&, const Directions<Integer>&);

}  // namespace strata::convex
