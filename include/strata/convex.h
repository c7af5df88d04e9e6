#pragma once
/// Convex polytopes, hulls, Minkowski sums, offsets, and decomposition into convex pieces.
///
/// All coordinates are exact: doubles as given, or rationals beside their nearest doubles. All functions are pure: they
/// may be called from many threads at once, and results do not depend on the number of threads.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {
template <int D>
class HyperplaneTable;  // internal
}  // namespace strata

namespace strata::convex {

/// The convex hull of finitely many points of space, of any dimension: the empty set (-1), a point (0), a segment (1),
/// a convex polygon (2), a solid (3). Every vertex is extreme: none is in the hull of the others.
struct Polytope {
  int dimension = -1;
  std::vector<Vertex> vertices;    ///< in lexicographic order of exact positions, rounded to nearest doubles
  std::vector<ExactVertex> exact;  ///< those for which rounding changed something, by increasing index
  /// Dimension 3: the maximal facets, counter-clockwise as seen from outside. Dimension 2: one facet, the polygon,
  /// in either direction. No facets in lower dimensions.
  std::vector<std::vector<std::uint32_t>> facets;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size())
};

/// The boundary of a polytope of dimension 3 as triangles, each facet a fan. No triangles in lower dimensions.
/// O(size).
[[nodiscard]] ExactMesh mesh_of(const Polytope& polytope);

/// A self-check for tests: the invariants of Polytope that do not hold, exactly, as sentences (order of vertices,
/// vertices that are not extreme, facets that are not maximal, planar or convex, dimension). Empty for every polytope
/// that a function here returns. O(vertices * facets).
[[nodiscard]] std::vector<std::string> violations(const Polytope& polytope);

/// The convex hull of all vertices of a view, whether triangles use them or not. Points may be equal, collinear and
/// coplanar, doubles of any magnitude, rationals.
/// Laws: depends on the set of points only, to the byte: not on their order, their multiplicity, or on threads. Every
/// facet begins with its lowest vertex, facets are in lexicographic order; of the two directions of a polygon
/// (dimension 2) it has the one whose second vertex is lower.
/// `threads` 0: all cores.
/// Throws std::invalid_argument for coordinates that are not finite and for exact positions that are not by increasing
/// index or do not round to the coordinates, and Cancelled. Expected O(n log n). Source: Quickhull (Barber, Dobkin,
/// Huhdanpaa 1996) with exact signs; lib/extensions/convex/theory.md, "Hulls".
[[nodiscard]] Polytope convex_hull(ExactMeshView points, unsigned threads = 0, const Monitor& monitor = {});
[[nodiscard]] Polytope convex_hull(std::span<const Vertex> points, unsigned threads = 0, const Monitor& monitor = {});

/// The convex hull of the union of solids, of dimension 3, or -1 when all are empty.
[[nodiscard]] Polytope convex_hull(std::span<const Solid> solids, unsigned threads = 0, const Monitor& monitor = {});

/// A polytope as a solid; of a dimension below 3, the empty solid.
[[nodiscard]] Solid solid_of(const Polytope& polytope);

/// The Minkowski sum {x + y : x in a, y in b} of two polytopes of any dimensions; empty if one of them
/// is.
/// Laws: commutative, associative, exact for all finite input. Throws std::overflow_error where a coordinate of the sum
/// is beyond all doubles, Cancelled. Facets come from overlaying the Gauss maps: O(n m) signs, most of them in doubles,
/// for n and m edges; the rest is O(n log n + m log m + size of the sum). Source: overlay of normal fans (Fogel and
/// Halperin 2007); lib/extensions/convex/theory.md, "Minkowski sums".
[[nodiscard]] Polytope sum(const Polytope& a, const Polytope& b, const Monitor& monitor = {});

/// The Minkowski sum {x + y : x in a, y in b} of two solids: any genus, cavities, several components, non-manifold
/// edges and vertices. Empty if one of them is. Exact. It is regular: so is the sum of a regular set and any compact
/// one. Laws: commutative; A + point is a translation; (A + B) + C = A + (B + C); monotone in both. Two convex solids
/// are added by their Gauss maps; for others the candidate faces (sums of a face and a vertex, and of two edges, that
/// have an outward direction in common) are arranged, and those pieces are kept that have the sum on one side only.
/// Proof: lib/extensions/convex/theory.md, "Minkowski sums". Of the options, the class of input and the engine are
/// ignored. Throws Cancelled, std::overflow_error where a coordinate is beyond all doubles, std::length_error as
/// `combine` does.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Solid& b, const Options& options = {});

/// The same for a polytope of any dimension: a point translates the solid, a segment sweeps it.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Polytope& b, const Options& options = {});

/// The sum of a solid and the union of some polytopes, such as the triangles of an open surface.
[[nodiscard]] Solid minkowski_sum(const Solid& a, std::span<const Polytope> b, const Options& options = {});

/// The erosion {x : x + b is a subset of a}, regularized. Laws: the largest solid whose Minkowski sum with b is a
/// subset of a; erosion(minkowski_sum(a, b), b) contains a. Throws as `minkowski_sum` does, and std::invalid_argument
/// where b is empty: the erosion would be all of space.
[[nodiscard]] Solid erosion(const Solid& a, const Solid& b, const Options& options = {});
[[nodiscard]] Solid erosion(const Solid& a, const Polytope& b, const Options& options = {});

/// The reflection in the origin: {-x : x in polytope}.
[[nodiscard]] Polytope reflected(const Polytope& polytope);

/// A polytope that contains the ball of a given radius about the origin and lies in the ball of (1 + excess) times that
/// radius.
struct Ball {
  Polytope polytope;
  double excess = 0;  ///< proven in rationals, rounded up
};

/// A geodesic ball: the faces of an icosahedron divided into f^2 triangles each, with f chosen so that the number of
/// facets is near the one given. Vertices are doubles of few bits, so that sums with them are mostly doubles, too. The
/// excess is about 5 / facets. Throws std::invalid_argument unless the radius is
/// positive, finite and at least 2^-900, and facets are 20 to 500,000; std::overflow_error beyond 2^1000.
[[nodiscard]] Ball ball(double radius, std::uint32_t facets);

/// A solid grown or shrunk by a distance, within a proven relative error.
struct Offset {
  Solid solid;
  double excess = 0;  ///< e: the distance is between |radius| and (1 + e) |radius| everywhere
};

/// The sum of a solid and `ball(radius, facets)`; for a negative radius its erosion by `ball(-radius, facets)`; itself
/// for 0. So the exact offset by a ball is a subset of the result for positive radii, a superset for negative ones.
/// Throws as `minkowski_sum`, `erosion` and `ball` do.
[[nodiscard]] Offset offset(const Solid& solid, double radius, std::uint32_t facets = 320, const Options& options = {});

/// A point of a decomposition, by number, as the meet of three planes.
struct MeetOfThree {
  std::uint32_t point = 0;
  std::array<std::uint32_t, 3> planes{};
};

/// A convex polygon in which two pieces of a decomposition touch.
struct Wall {
  std::array<std::uint32_t, 2> pieces;  ///< the lower number first
  std::vector<std::uint32_t> polygon;   ///< convex; counter-clockwise as seen from the second piece
};

/// A convex part of the solid's boundary: the intersection of a piece and a triangle.
struct BoundaryPart {
  std::uint32_t piece = 0;
  std::uint32_t triangle = 0;          ///< of the solid's mesh
  std::vector<std::uint32_t> polygon;  ///< convex; counter-clockwise as seen from outside
};

/// A solid as convex pieces, over one list of points: pieces that touch share the corners there.
struct Decomposition {
  /// A convex polygon, counter-clockwise as seen from outside of its piece.
  using Polygon = std::vector<std::uint32_t>;

  std::vector<Vertex> points;  ///< corners of all polygons, in lexicographic order of exact positions; nearest doubles
  std::vector<MeetOfThree> meets;            ///< those for which rounding changed something, by increasing point
  Shared<HyperplaneTable<3>> planes;         ///< of `meets`, each through three vertices of the solid; internal
  std::vector<std::vector<Polygon>> pieces;  ///< each by its facets, one per plane
  std::vector<Wall> walls;                   ///< sorted by pieces
  std::vector<BoundaryPart> boundary;        ///< all of it, sorted by triangles, then pieces
  std::size_t reflex_edges = 0;  ///< of the solid: angles of more than 180 degrees, non-manifold edges may have several
  std::size_t cuts = 0;          ///< divisions of a region by a plane, before pieces were merged

  [[nodiscard]] RationalPoint position(std::uint32_t point) const;  ///< exact; computed by each call
  [[nodiscard]] std::vector<ExactVertex> exact() const;             ///< the positions of all `meets`
  [[nodiscard]] Polytope polytope(std::uint32_t piece) const;       ///< O(size of the piece)
};

/// Divides a solid into convex pieces with disjoint interiors whose union is the solid.
///
/// A convex region of space with reflex edges in it (interior angles of more than 180 degrees) is cut by a plane
/// through one of them: that of a face, or one through two reflex edges. The parts of the solid in a region without
/// reflex edges are convex. In the end pieces whose union is convex are merged. So every vertex of a piece is the meet
/// of three planes, each through three vertices of the solid: coefficients do not grow. Any genus, cavities, several
/// components, non-manifold edges and vertices.
///
/// r reflex edges take O(r^2) cuts; typical solids have about r pieces. (A minimum number is NP-hard to find.) Expected
/// O(n log n) where cuts are balanced; O(n^2) where every cut takes off little, as around a cavity with thousands of
/// faces. The same result on any machine. Requires that the solid touches itself in common vertices and edges only, as
/// results of operations do, and as `check` finds. Throws std::invalid_argument where a triangle has no area, and where
/// it is found that the solid touches itself elsewhere; Cancelled.
/// Source: Chazelle 1984; lib/extensions/convex/theory.md, "Decomposition".
[[nodiscard]] Decomposition decompose(const Solid& solid, const Monitor& monitor = {});

/// The pieces of a decomposition as solids with what the solid carries, as of an intersection of the solid and the
/// piece (carry_attributes.h). What lies on the solid's surface has the attributes of the triangle that it is a part
/// of; walls have those of an operand that has none, and Options::cut_material, if it is given. All pieces have the
/// same channels and lists.
/// Every triangle is a part of a triangle of the solid or of a wall, so there are more than in `mesh_of(polytope)`.
/// Sources: operand 0 is the solid; operand 1 are the walls, by their number in `walls`. Pieces that touch need not
/// divide their common wall in the same way. Requires that the decomposition is that of the solid. Of the options
/// `threads`, `cancel` and `cut_material` count. Exact. O(n log n), and for sides of polygons that do not meet whole
/// sides the points of their piece. Throws what `carry_attributes` throws.
[[nodiscard]] std::vector<Solid> pieces_of(const Solid& solid, const Decomposition& decomposition,
                                           const Options& options = {});

/// What a volume of space is: the unbounded outside, a cavity, or a piece of the solid.
enum class Mark { outer, cavity, piece };

/// A part of a volume's boundary that is connected over edges as seen from inside the volume, as increasing numbers of
/// interfaces. Of two cubes that touch in an edge, the outside has one shell; of two that touch in a vertex, two.
using Shell = std::vector<std::uint32_t>;

/// A part of space between interfaces.
struct Volume {
  Mark mark = Mark::outer;
  /// One for a piece; the outside has one per component of the solid's outer boundary; a cavity has first the one that
  /// encloses it, then one per component of the solid within it. Otherwise in the order of their first triangles.
  std::vector<Shell> shells;
  std::vector<std::uint32_t> neighbours;  ///< volumes that it shares an interface with, increasing
};

/// A convex polygon between two volumes.
struct Interface {
  std::array<std::uint32_t, 2> volumes;  ///< of two pieces the lower number first, otherwise the piece first
  std::vector<std::uint32_t> polygon;    ///< counter-clockwise as seen from the second volume
};

/// Space as divided by a solid and its decomposition. Volume 0 is the outside, then come the cavities, in the order of
/// their first triangles, then the pieces: piece p is volume `first_piece + p`.
struct VolumeComplex {
  std::vector<Vertex> points;      ///< in lexicographic order of exact positions
  std::vector<ExactVertex> exact;  ///< those that are not three doubles
  std::vector<Volume> volumes;
  std::vector<Interface> interfaces;  ///< walls first, in their order, then parts of the boundary, by triangle
  std::uint32_t first_piece = 1;
};

/// The volumes of a solid and its decomposition. Requires that the decomposition is that of the solid. Expected
/// O(n log n).
[[nodiscard]] VolumeComplex volumes_of(const Solid& solid, const Decomposition& decomposition);

}  // namespace strata::convex
