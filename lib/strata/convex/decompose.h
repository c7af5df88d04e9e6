#pragma once
#include <array>
#include <cstdint>
#include <vector>

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

  std::vector<Vertex> points;      ///< in lexicographic order of their exact places, rounded to nearest doubles
  std::vector<ExactVertex> exact;  ///< those for which rounding changed something
  std::vector<std::vector<Polygon>> pieces;  ///< by their facets, one per plane
  std::vector<Wall> walls;                   ///< by pieces
  std::vector<BoundaryPart> boundary;        ///< by triangles, then pieces; all of the boundary
  std::size_t reflex_edges = 0;  ///< of the solid: angles of more than 180 degrees, non-manifold edges may have several
  std::size_t cuts = 0;          ///< planes that divided something, before pieces were joined

  [[nodiscard]] RationalPoint position(std::uint32_t point) const;
  [[nodiscard]] Polytope polytope(std::uint32_t piece) const;  ///< O(size of the piece)
};

/// Divides a solid into convex pieces: their interiors are apart, and together they are the solid.
///
/// A part of space that holds reflex edges is divided by a plane through some of them, the plane of a face or through
/// two reflex edges; where no edge is reflex, everything inside is convex. In the end pieces whose union is convex are
/// joined. So every vertex of a piece is a meet of three planes, and each plane goes through three vertices of the
/// solid: coefficients do not grow. Any genus, cavities, several components, edges and vertices that touch.
///
/// r reflex edges give O(r^2) pieces; most solids need about r, convex ones one. A minimum is NP-hard to find.
/// Expected O(n log n) for solids whose cuts are short; theory.md, "Decomposition". The same for any machine.
/// Source of the problem: Chazelle, Convex partitions of polyhedra, 1984. Throws Cancelled.
[[nodiscard]] Decomposition decompose(const Solid& solid, const Monitor& monitor = {});

}  // namespace strata::convex
