#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/options.h"

namespace strata::convex {

/// A convex polygon that is part of the surface of a piece, counter-clockwise as seen from outside; every corner is a
/// vertex of it.
struct PiecePolygon {
  std::vector<std::uint32_t> corners;
  Source source;
};

/// The surface of a piece as triangles, each part of one polygon.
struct PieceSurface {
  std::vector<Triangle> triangles;
  std::vector<Source> sources;
};

/// Triangulates the polygons that tile the surface of a convex piece. Where a corner of one lies within a side of
/// another, the side is divided: the triangles share whole edges. Requires points in lexicographic order of exact
/// positions. Decisions are exact; no triangle is degenerate. O(n log n) where the polygons share whole sides; sides
/// that they do not share are compared with the points between their ends.
[[nodiscard]] PieceSurface piece_surface(ExactMeshView points, std::span<const PiecePolygon> polygons);

}  // namespace strata::convex
