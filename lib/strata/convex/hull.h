#pragma once
#include <span>

#include "strata/convex/polytope.h"
#include "strata/csg/solid.h"
#include "strata/mesh/exact_mesh.h"

namespace strata::convex {

/// The convex hull of the vertices of a view, used or not; triangles do not matter. Any points: equal, collinear and
/// coplanar ones, doubles of any magnitude, rationals. Facets are maximal, and a point that lies between others is no
/// vertex.
/// Laws: depends on the set of points only, to the byte: neither on their order and number, nor on threads. Every loop
/// begins with its lowest vertex, loops are in lexicographic order; a polygon goes on to the lower neighbour.
/// `threads` 0: all cores.
/// Throws std::invalid_argument for coordinates that are not finite and for exact places that are not by increasing
/// index or do not round to the coordinates. Expected O(n log n). Source: Quickhull (Barber, Dobkin, Huhdanpaa 1996)
/// with exact signs; theory.md, "Hulls".
[[nodiscard]] Polytope convex_hull(ExactMeshView points, unsigned threads = 0);
[[nodiscard]] Polytope convex_hull(std::span<const Vertex> points, unsigned threads = 0);

/// The convex hull of the union of solids, of dimension 3, or -1 when all are empty.
[[nodiscard]] Polytope convex_hull(std::span<const Solid> solids, unsigned threads = 0);

/// A polytope as a solid; below dimension 3 the empty one.
[[nodiscard]] Solid solid_of(const Polytope& polytope);

}  // namespace strata::convex
