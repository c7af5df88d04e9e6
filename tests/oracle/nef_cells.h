#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/measure.h"
#include "strata/mesh.h"

namespace strata::oracle {

/// A surface of flat, convex polygons, open or closed, which have whole edges and vertices in common and nothing else:
/// oriented alike, outwards if it is closed; every edge in one or two of them, around every vertex one fan.
struct PolygonSurface {
  std::vector<Vertex> points;
  std::vector<std::vector<std::uint32_t>> polygons;
};

/// Ways to one and the same union. CGAL 5.5 sometimes crashes or answers wrongly on one of them.
enum class UnionWay {
  surfaces,   ///< a polyhedron with a border per surface
  backwards,  ///< the same in the reverse order
  polygons,   ///< every polygon from its cycle of vertices
};

/// A facet of CGAL's complex, seen from where its outer loop is counter-clockwise, and the cells beside it.
struct NefFacet {
  ExactFacet loops;
  std::uint32_t in_front = 0, behind = 0;
};

/// The cells into which the union of surfaces divides space. Number 0 is CGAL's outer one.
struct NefCells {
  std::vector<NefFacet> facets;
  std::uint32_t count = 0;
};

/// The complex of the union of all surfaces, as CGAL's Nef polyhedron of the points in them; nothing is regularized, so
/// that facets within a cell count, too. Without any code of the library. Throws OracleFailed.
[[nodiscard]] NefCells nef_cells(std::span<const PolygonSurface> surfaces, UnionWay way);

}  // namespace strata::oracle
