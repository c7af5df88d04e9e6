#pragma once
/// Convex polytopes, hulls, Minkowski sums, offsets, and decomposition into convex pieces.
///
/// All coordinates are exact: doubles as given, or rationals beside their nearest doubles.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {
template <int D>
class HyperplaneTable;  // internal
}  // namespace strata

namespace strata::convex {

/// The convex hull of finitely many points of space, of any dimension: nothing (-1), a point, a segment, a convex
/// polygon, a solid (3). Every vertex is extreme: none lies between others.
struct Polytope {
  int dimension = -1;
  std::vector<Vertex> vertices;    ///< in lexicographic order of their exact places, rounded to nearest doubles
  std::vector<ExactVertex> exact;  ///< those for which rounding changed something, by increasing index
  /// Dimension 3: the maximal facets, counter-clockwise as seen from outside. Dimension 2: the polygon, one loop, in
  /// either direction. No facets below.
  std::vector<std::vector<std::uint32_t>> facets;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size())
};

/// The boundary of a polytope of dimension 3 as triangles, each facet a fan; without triangles below. O(size).
[[nodiscard]] ExactMesh mesh_of(const Polytope& polytope);

/// What is wrong with it, exactly, in words: an order that is not one, vertices that are not extreme, facets that are
/// not maximal, not planar or not convex, dimension. Empty for what this room returns. O(vertices * facets).
[[nodiscard]] std::vector<std::string> violations(const Polytope& polytope);

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

/// The Minkowski sum {x + y : x in a, y in b} of two polytopes of any dimensions; nothing if one of them is.
/// Laws: commutative, associative, exact for all finite input. Throws std::overflow_error where a coordinate of the sum
/// is beyond all doubles. Facets come from overlaying the Gauss maps: O(n m) signs, most of them in doubles, for n and
/// m edges; the rest is O(n log n + m log m + size of the sum). Source: overlay of normal fans (Fogel and Halperin
/// 2007); theory.md, "Minkowski sums".
[[nodiscard]] Polytope sum(const Polytope& a, const Polytope& b);

/// The Minkowski sum {x + y : x in a, y in b} of two solids: any genus, cavities, several parts, edges and vertices of
/// several sheets. Empty if one of them is. Exact; regular as it is, since a solid plus anything is.
/// Laws: commutative; A + point is a translation; (A + B) + C = A + (B + C); monotone in both.
/// Two convex solids are added by their Gauss maps; else the faces in which both may touch, sums of faces, vertices and
/// pairs of edges with outward directions in common, are arranged, and the pieces on the outside are the boundary.
/// theory.md, "Minkowski sums", has the proof.
/// Of the options, the class of input and the engine are ignored. Throws Cancelled, std::overflow_error where a
/// coordinate is beyond all doubles, std::length_error as `combine` does.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Solid& b, const Options& options = {});

/// The same for a polytope of any dimension: a point moves the solid, a segment sweeps it.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Polytope& b, const Options& options = {});

/// The sum of a solid and the union of some polytopes, such as the triangles of an open surface.
[[nodiscard]] Solid minkowski_sum(const Solid& a, std::span<const Polytope> b, const Options& options = {});

/// Where b fits: {x : x + b within a}, regularized (without parts that have no volume). a, if b is empty, would be all
/// of space: then throws std::invalid_argument. Laws: the largest solid X with X + b within a, but for parts without
/// volume; erosion(minkowski_sum(a, b), b) contains a.
[[nodiscard]] Solid erosion(const Solid& a, const Solid& b, const Options& options = {});
[[nodiscard]] Solid erosion(const Solid& a, const Polytope& b, const Options& options = {});

/// The polytope turned about the origin: {-x}.
[[nodiscard]] Polytope reflected(const Polytope& polytope);

/// A polytope that contains the ball of a radius about the origin and lies in the ball of radius (1 + excess) times it.
struct Ball {
  Polytope polytope;
  double excess = 0;  ///< proven in rationals, rounded up
};

/// A geodesic ball: an icosahedron's faces divided into f^2 triangles each, f chosen so that there are nearly as many
/// facets as asked for. Vertices are doubles on a grid of a few more bits than the shape needs: sums with them seldom
/// need more than doubles have. The excess is about 5 / facets. Throws std::invalid_argument unless the radius is
/// positive, finite and at least 2^-900, and facets are 20 to 500,000; std::overflow_error beyond 2^1000.
[[nodiscard]] Ball ball(double radius, std::uint32_t facets);

/// A solid grown or shrunk by about a distance.
struct Offset {
  Solid solid;
  double excess = 0;  ///< e: the distance is between |radius| and (1 + e) |radius| everywhere
};

/// The sum of a solid and `ball(radius, facets)`; for a negative radius its erosion by `ball(-radius, facets)`; itself
/// for 0. So what is within the radius is in the result (or all that is eroded by the exact ball is gone).
/// Throws as `minkowski_sum`, `erosion` and `ball` do.
[[nodiscard]] Offset offset(const Solid& solid, double radius, std::uint32_t facets = 320, const Options& options = {});

/// A point, by number, where three planes of a decomposition meet.
struct MeetOfThree {
  std::uint32_t point = 0;
  std::array<std::uint32_t, 3> planes{};
};

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

  std::vector<Vertex> points;         ///< corners of pieces, walls and boundary parts, by exact places; nearest doubles
  std::vector<MeetOfThree> meets;     ///< those for which rounding changed something, rising
  Shared<HyperplaneTable<3>> planes;  ///< that meet there, each through three vertices of the solid
  std::vector<std::vector<Polygon>> pieces;  ///< by their facets, one per plane
  std::vector<Wall> walls;                   ///< by pieces
  std::vector<BoundaryPart> boundary;        ///< by triangles, then pieces; all of the boundary
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

/// What a volume of space is: a piece of the solid is selected, the outside and cavities are not.
enum class Mark { outer, cavity, piece };

/// A part of a volume's boundary that is connected over edges as seen from inside the volume, as interfaces by number,
/// rising. Seen from outside, two cubes that touch in an edge are one part, two that touch in a vertex are two.
using Shell = std::vector<std::uint32_t>;

/// A part of space between interfaces.
struct Volume {
  Mark mark = Mark::outer;
  /// One for a piece; the outside has one per connected part of the solid's outer boundary, a cavity first the one that
  /// encloses it, then one per part that floats in it. In the order of their first triangles.
  std::vector<Shell> shells;
  std::vector<std::uint32_t> neighbours;  ///< volumes that it shares an interface with, rising
};

/// A convex polygon between two volumes.
struct Interface {
  std::array<std::uint32_t, 2> volumes;  ///< of two pieces the lower number first, otherwise the piece first
  std::vector<std::uint32_t> polygon;    ///< counter-clockwise as seen from the second volume
};

/// Space as divided by a solid and its decomposition. Volume 0 is the outside, then come the cavities, in the order of
/// their first triangles, then the pieces: piece p is volume `first_piece + p`.
struct VolumeComplex {
  std::vector<Vertex> points;      ///< in lexicographic order of their exact places
  std::vector<ExactVertex> exact;  ///< those that are no doubles
  std::vector<Volume> volumes;
  std::vector<Interface> interfaces;  ///< walls first, in their order, then parts of the boundary, by triangle
  std::uint32_t first_piece = 1;
};

/// Requires that the decomposition is that of the solid. Expected O(n log n); where
/// there are cavities and more outer shells than one, beside a search tree for each cavity.
[[nodiscard]] VolumeComplex volumes_of(const Solid& solid, const Decomposition& decomposition);

}  // namespace strata::convex
