#pragma once
#include <span>

#include "strata/mesh.h"

namespace strata::io {

/// What a polygon turned out to be.
struct PolygonShape {
  bool planar = true;  ///< all vertices lie in one plane, exactly
  bool simple = true;  ///< no defect was met on the way: sides that cross, spikes, no area at all
};

/// Triangulates a closed polygon of n >= 3 corners into exactly n - 2 triangles of corner numbers, oriented as the
/// polygon is. Every side of the polygon is a side of one triangle: nothing is dropped, collinear corners included.
/// Planar and simple polygons, also those that meet themselves in corners and along whole sides (keyholes), are divided
/// exactly: no triangle is degenerate, none overlaps another. A polygon that is not planar is divided as it is seen
/// along the axis in which it is largest. One that is not simple is divided somehow, deterministically. `triangles` has
/// room for n - 2. O(n) for convex polygons, O(n^2) at worst, near O(n log n) for most. Source: ears, Meisters 1975.
PolygonShape triangulate(std::span<const Vertex> loop, std::span<Triangle> triangles);

}  // namespace strata::io
