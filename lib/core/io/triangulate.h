#pragma once
#include <span>

#include "strata/mesh.h"

namespace strata::io {

/// The properties found of a polygon.
struct PolygonShape {
  bool planar = true;  ///< all vertices lie in one plane, exactly
  bool simple = true;  ///< no defect was found: sides that cross, spikes, zero area
};

/// Triangulates a closed polygon of n >= 3 corners into exactly n - 2 triangles of corner numbers, with the polygon's
/// orientation. Every side of the polygon is a side of one triangle; collinear corners are kept. Planar and simple
/// polygons, also those that meet themselves in corners and along whole sides (keyholes), are triangulated exactly: no
/// triangle is degenerate, none overlaps another. A polygon that is not planar is triangulated in the projection along
/// the axis in which its area is largest. A polygon that is not simple gets a deterministic set of triangles.
/// `triangles` has room for n - 2. O(n) for convex polygons, O(n^2) in the worst case, near O(n log n) for most.
/// Source: ears, Meisters 1975.
PolygonShape triangulate(std::span<const Vertex> loop, std::span<Triangle> triangles);

}  // namespace strata::io
