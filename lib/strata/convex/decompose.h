#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "strata/convex/point_list.h"
#include "strata/convex/polytope.h"
#include "strata/csg/solid.h"
#include "strata/mesh/monitor.h"

namespace strata::convex {

/// Where two pieces of a decomposition touch with an area.
struct Wall {
  std::array<std::uint32_t, 2> pieces;  ///< the lower number first
  std::vector<std::uint32_t> polygon;   ///< convex; counter-clockwise as seen from the second piece
};

/// A part of the solid's boundary: a piece has it in common with one triangle.
struct BoundaryPart {
  std::uint32_t piece = 0;
  std::uint32_t triangle = 0;          ///< of the solid's mesh
  std::vector<std::uint32_t> polygon;  ///< convex; counter-clockwise as seen from outside
};

/// A solid as convex pieces. All of them share one list of points: pieces that touch do so exactly.
struct Decomposition {
  /// A convex polygon with outside on the side from where it is counter-clockwise.
  using Polygon = std::vector<std::uint32_t>;

  std::vector<Vertex> points;      ///< corners of pieces, walls and boundary parts, by exact places; nearest doubles
  std::vector<MeetOfThree> meets;  ///< those for which rounding changed something, rising
  std::shared_ptr<const HyperplaneTable<3>> planes;  ///< that meet there, each through three vertices of the solid
  std::vector<std::vector<Polygon>> pieces;          ///< by their facets, one per plane
  std::vector<Wall> walls;                           ///< by pieces
  std::vector<BoundaryPart> boundary;                ///< by triangles, then pieces; all of the boundary
  std::size_t reflex_edges = 0;  ///< of the solid: angles of more than 180 degrees, non-manifold edges may have several
  std::size_t cuts = 0;          ///< divisions of a region by a plane, before pieces were joined

  [[nodiscard]] RationalPoint position(std::uint32_t point) const;  ///< exact; made when asked for
  [[nodiscard]] std::vector<ExactVertex> exact() const;             ///< the places of all `meets`
  [[nodiscard]] Polytope polytope(std::uint32_t piece) const;       ///< O(size of the piece)
};

/// Divides a solid into convex pieces: their interiors are apart, and together they are the solid.
///
/// A part of space that holds reflex edges is divided by a plane through some of them, the plane of a face or through
/// two reflex edges; where no edge is reflex, everything inside is convex. In the end pieces whose union is convex are
/// joined. So every vertex of a piece is a meet of three planes, and each plane goes through three vertices of the
/// solid: coefficients do not grow. Any genus, cavities, several components, edges and vertices that touch.
///
/// r reflex edges take O(r^2) cuts; most solids have about r pieces, and none of the tests has more than r + r^2 / 4
/// besides one for each part of its inside. A minimum is NP-hard to find. Expected O(n log n) where cuts leave parts of
/// about one size; O(n^2) where every cut takes off little, as about a cavity with thousands of faces. The same on any
/// machine. Requires triangles with area, and that the solid touches itself in common vertices and edges only: as
/// results of Booleans do, and as check() finds. Throws std::invalid_argument where a triangle has no area, or where
/// pieces certainly lack a part of a solid that touches itself elsewhere.
/// Source of the problem: Chazelle, Convex partitions of polyhedra, 1984; theory.md, "Decomposition". Throws Cancelled.
[[nodiscard]] Decomposition decompose(const Solid& solid, const Monitor& monitor = {});

}  // namespace strata::convex
