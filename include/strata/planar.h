#pragma once
/// Polygons in the plane: Booleans, checks, point location, contacts, and files (WKT, GeoJSON, SVG paths). Exact.
///
/// Loops are what is given: closed polygons, which may cross. A Region is what they fill: simple polygons with holes.
/// All functions may be called from many threads at once.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "strata/coordinate_grid.h"
#include "strata/errors.h"
#include "strata/file_path.h"
#include "strata/function.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"

namespace strata::planar {

/// Coordinates in the plane, in model units.
using PlanePoint = std::array<double, 2>;

/// "No such number" wherever points and lines are numbered.
inline constexpr std::uint32_t none = 0xffffffff;

/// A point with rational coordinates.
using RationalPlacement = std::array<Rational, 2>;

/// The point between p and q at which a quantity is `at` that is `from` at p and `to` at q, and linear between them:
/// its coordinates are p + (q - p) (at - from) / (to - from). Such is the point where an edge of space crosses a plane
/// across an axis. Requires finite doubles, and from < at < to or from > at > to.
struct PointBetween {
  PlanePoint p{}, q{};
  double from = 0, to = 0, at = 0;
  friend bool operator==(const PointBetween&, const PointBetween&) = default;
};

/// A point with rational coordinates: these, or what they are computed from whenever they are asked for.
class RationalPlace {
 public:
  RationalPlace(RationalPlacement p) : kept_(std::move(p)) {}     // NOLINT: coordinates are a place
  RationalPlace(const PointBetween& between) : kept_(between) {}  // NOLINT: and so is this

  [[nodiscard]] RationalPlacement exact() const;
  /// Null where coordinates were given.
  [[nodiscard]] const PointBetween* between() const { return std::get_if<PointBetween>(&kept_); }
  /// Null where they are computed.
  [[nodiscard]] const RationalPlacement* given() const { return std::get_if<RationalPlacement>(&kept_); }

 private:
  std::variant<RationalPlacement, PointBetween> kept_;
};

/// The directed line through two given points, by their numbers.
struct Line {
  std::uint32_t from = 0, to = 0;
  friend bool operator==(const Line&, const Line&) = default;
};

/// The point where two lines meet, by their numbers; they are not parallel.
struct Meet {
  std::uint32_t first = 0, second = 0;
  friend bool operator==(const Meet&, const Meet&) = default;
};

/// Points and lines by number. A point is *given* (two doubles, or two rationals) or the *meet* of two lines; a line
/// goes through two given points. So however many operations led to a point, its coordinates are quotients of
/// polynomials of degree 3 and 2 in given coordinates.
///
/// Numbers: points given as doubles come first, then those given as rationals, then meets.
/// `place` and `error` hold the exact point: |exact - place[i]| <= error (as in `Bounded`) for each coordinate.
struct Places {
  std::vector<PlanePoint> place;         ///< of every point; exact for doubles
  std::vector<PlanePoint> error;         ///< of every point that is not given as doubles
  std::vector<RationalPlace> rationals;  ///< of every point given as rationals
  std::vector<Meet> meets;               ///< of every point that is a meet
  std::vector<Line> lines;               ///< no line's points are equal, except where a segment is a single point

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(place.size()); }
  /// How many points are given as doubles: the first ones.
  [[nodiscard]] std::uint32_t doubles() const { return static_cast<std::uint32_t>(place.size() - error.size()); }
  /// How many points are given at all.
  [[nodiscard]] std::uint32_t given() const { return static_cast<std::uint32_t>(place.size() - meets.size()); }
  [[nodiscard]] bool is_double(std::uint32_t p) const { return p < doubles(); }
  [[nodiscard]] bool is_meet(std::uint32_t p) const { return p >= given(); }
  [[nodiscard]] const Meet& meet(std::uint32_t p) const { return meets[p - given()]; }
  [[nodiscard]] const RationalPlace& rational(std::uint32_t p) const { return rationals[p - doubles()]; }

  /// Appends a point; doubles before rationals before meets. Requires finite doubles and lines that are not parallel.
  std::uint32_t add(const PlanePoint& p);
  std::uint32_t add(RationalPlace p);
  std::uint32_t add(const Meet& m);
  /// Takes the last meets away, so that `count` points are left.
  void drop_meets(std::uint32_t count);
};

/// The exact coordinates of a point. O(1) operations on rationals.
[[nodiscard]] RationalPlacement exact_position(const Places& places, std::uint32_t point);

/// The doubles nearest to a point's coordinates, ties to even. Mostly settled by 106-bit arithmetic.
[[nodiscard]] PlanePoint nearest_place(const Places& places, std::uint32_t point);

/// Polyloops: cyclic lists of vertices, each joined to the next by an edge. No invariant: they may cross themselves and
/// each other, touch, run back along themselves, or consist of one vertex.
///
/// An edge lies on the line through its ends, or, if one of them is a meet, on a given line that `edge_line` names; so
/// results of operations keep the lines that their edges came from. `places` also has points that are no vertices, but
/// define lines.
struct Loops {
  Places places;
  std::vector<std::uint32_t> vertices;  ///< of all loops, one loop after the other
  std::vector<std::uint32_t>
      edge_line;  ///< of the edge from vertex i to the next; none: the line through both (given) ends
  std::vector<std::uint32_t> first_vertex{0};  ///< of every loop, in `vertices`, and the count

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(first_vertex.size() - 1); }
  [[nodiscard]] std::span<const std::uint32_t> loop(std::uint32_t i) const {
    return {vertices.data() + first_vertex[i], vertices.data() + first_vertex[i + 1]};
  }
  /// Appends a loop of points given as doubles. Requires finite ones, and that all points are doubles.
  void add(std::span<const PlanePoint> loop);
};

/// Collects loops of points that are doubles or rationals.
class LoopsBuilder {
 public:
  void add_vertex(const PlanePoint& p);
  void add_vertex(RationalPlace p);  ///< rationals that are doubles are taken as such
  void end_loop();
  [[nodiscard]] Loops finish();

 private:
  std::vector<PlanePoint> doubles_;
  Places rationals_;
  std::vector<std::array<std::uint32_t, 2>> vertices_;  ///< 0 and a double's number, or 1 and a rational's
  std::vector<std::uint32_t> first_vertex_{0};
};

/// Loops from lists of points.
[[nodiscard]] Loops loops_of(std::span<const std::vector<PlanePoint>> loops);

/// Twice the area that the loops wind around, counter-clockwise positive: the sum of vertex cross products. Exact;
/// rationals of meets grow with their number, so this takes O(k log k) operations on numbers of up to k times the size
/// of one meet.
[[nodiscard]] Rational twice_area(const Loops& loops, std::span<const std::uint32_t> loop);
[[nodiscard]] Rational twice_area(const Loops& loops);

/// A bounded open regular set as its polygons: the components of its interior, which are disjoint.
///
/// What holds: every loop is simple (a clean polyloop); loops meet in vertices only. A polygon's outer loop is
/// counter-clockwise, its holes are clockwise: the polygon lies to the left of every edge. Where a polygon's boundary
/// touches itself, loops share the vertex, so a polygon without holes is simple. Vertices are corners, or are on the
/// boundary more than once: no edge goes straight on elsewhere. Every loop starts at its lexicographically least
/// vertex; polygons, and the holes of each, are in the order of their first vertices, then of their second ones: what
/// is listed, and in which order, depends on the set alone. `places.place` of every point is its nearest double.
struct Region {
  Loops loops;
  std::vector<std::uint32_t> first_loop{
      0};  ///< of every polygon, its outer loop; then its holes; and the count of loops

  [[nodiscard]] std::uint32_t polygons() const { return static_cast<std::uint32_t>(first_loop.size() - 1); }
  [[nodiscard]] std::uint32_t holes(std::uint32_t polygon) const {
    return first_loop[polygon + 1] - first_loop[polygon] - 1;
  }
  [[nodiscard]] bool empty() const { return polygons() == 0; }
};

/// Exact areas.
[[nodiscard]] Rational area(const Region& region);
[[nodiscard]] Rational area(const Region& region, std::uint32_t polygon);

/// A polygon by how its boundary touches itself.
struct PolygonKind {
  bool is_manifold = true;  ///< no vertex is on its loops twice
  bool is_simply_connected =
      true;  ///< the complement of the open set is connected: every hole touches the outside, in the end
  /// Manifold and simply connected.
  [[nodiscard]] bool is_simple() const { return is_manifold && is_simply_connected; }
};
[[nodiscard]] PolygonKind kind_of(const Region& region, std::uint32_t polygon);

/// A region as a point set, for comparison: loops of exact corners, each from its least one, sorted. Two regions are
/// equal as sets exactly when their canonical forms are.
[[nodiscard]] std::vector<std::vector<RationalPlacement>> canonical_form(const Region& region);

/// Which points loops fill, by how often the loops wind around them.
enum class FillRule {
  even_odd,  ///< an odd number of times
  nonzero,   ///< not zero
  positive,  ///< counter-clockwise more often than clockwise
  negative,
};

[[nodiscard]] constexpr bool is_filled(FillRule rule, std::int32_t winding) {
  switch (rule) {
    case FillRule::even_odd:
      return (winding & 1) != 0;
    case FillRule::nonzero:
      return winding != 0;
    case FillRule::positive:
      return winding > 0;
    case FillRule::negative:
      return winding < 0;
  }
  return false;
}

/// The operands that a point is in.
struct Inside {
  std::vector<std::uint8_t> is_in;  ///< by operand
  std::uint32_t count = 0;          ///< how many
};

/// A Boolean combination of operands, as a function of the operands that a point is in.
using Combination = Function<bool(const Inside&)>;

using strata::Operation;

[[nodiscard]] inline bool holds(Operation operation, const Inside& inside) {
  switch (operation) {
    case Operation::union_:
      return inside.count > 0;
    case Operation::intersection:
      return inside.count == inside.is_in.size() && inside.count > 0;
    case Operation::difference:
      return inside.count == 1 && inside.is_in.front() != 0;
    case Operation::symmetric_difference:
      return (inside.count & 1) != 0;
  }
  return false;
}

/// Loops with their fill rule, or a region, as an operand. Refers to them: they must outlive it.
struct Operand {
  const Loops* loops = nullptr;
  FillRule fill = FillRule::nonzero;

  Operand(const Loops& l, FillRule f = FillRule::nonzero) : loops(&l), fill(f) {}  // NOLINT: loops are an operand
  Operand(const Region& r) : loops(&r.loops) {}                                    // NOLINT: and so is a region
};

/// The combination holds outside of all operands, so the result would be unbounded.
class UnboundedResult : public std::runtime_error {
 public:
  UnboundedResult() : std::runtime_error("the combination holds outside of all operands: the result is unbounded") {}
};

/// The open regularization of a Boolean combination of the sets that the operands fill: its polygons. Exact for all
/// finite input. O((n + k) log n) for k points inside edges; one arrangement, whatever the number of operands. Laws:
/// those of Boolean algebra, up to regularization; the same for loops started elsewhere and for operands in another
/// order. Throws UnboundedResult, Cancelled.
[[nodiscard]] Region combine(std::span<const Operand> operands, Operation operation, const Monitor& monitor = {});
[[nodiscard]] Region combine(std::span<const Operand> operands, const Combination& combination,
                             const Monitor& monitor = {});

[[nodiscard]] Region union_(const Operand& a, const Operand& b);
[[nodiscard]] Region intersection(const Operand& a, const Operand& b);
[[nodiscard]] Region difference(const Operand& a, const Operand& b);
[[nodiscard]] Region symmetric_difference(const Operand& a, const Operand& b);
/// The region that loops fill. Throws as `combine` does.
[[nodiscard]] Region fill(const Operand& a);

/// How polyloops fail to be clean, that is, how two of their vertices and edges share a point.
enum class SelfMeetingKind {
  vertex_on_vertex,   ///< several vertices have one position
  vertex_on_edge,     ///< vertices lie inside edges
  edges_crossing,     ///< edges share a point inside each of them
  edges_overlapping,  ///< edges share a stretch, from `where` to `to`
  lone_vertex,        ///< a loop of one vertex has no edges
};
[[nodiscard]] std::string_view name(SelfMeetingKind kind);  ///< "vertex on edge"

struct SelfMeeting {
  SelfMeetingKind kind = SelfMeetingKind::vertex_on_vertex;
  RationalPlacement where, to;          ///< exact; `to` of overlaps only
  std::vector<std::uint32_t> vertices;  ///< at `where`, as indices of `Loops::vertices`
  std::vector<std::uint32_t> edges;     ///< through `where`, by the indices of the vertices they start from
};

/// Every point or stretch in which the loops, all together, meet themselves, and loops of one vertex. Loops are clean
/// when there is none; the edges of a loop of two vertices overlap. O((n + k) log n).
[[nodiscard]] std::vector<SelfMeeting> self_intersections(const Loops& loops);

/// True when `self_intersections` finds none: loops are simple, disjoint, and of three vertices or more.
[[nodiscard]] bool is_clean(const Loops& loops);

/// Where a region's loops, with every vertex at its nearest double, would meet other than in the vertices that they
/// share: what must be known before the rounded region is taken for a region. Empty where all vertices are doubles. O(n
/// log n).
[[nodiscard]] std::vector<SelfMeeting> rounding_conflicts(const Region& region);

/// A region whose vertices are on a grid, and how it came about.
struct RoundedRegion {
  Region region;
  std::uint32_t rounds = 0;  ///< how often crossings of rounded edges became vertices, which were rounded in turn
  /// No point of the boundary is farther from the boundary before, in the maximum norm: a bound, as the sum of what
  /// each rounding moved.
  double largest_movement = 0;
};

/// A region rounded to a grid such that it is a region again: loops are simple and meet in vertices only. Every vertex
/// takes the nearest numbers of the grid. Where rounded edges cross then, the region is what the loops wind around
/// counter-clockwise more often than clockwise; the vertices which that makes are rounded in turn, until there are
/// none. From the fourth round on, edges are snapped to pixels that have vertices in them. Parts that the grid cannot
/// hold vanish. The area changes by at most the movement times the lengths of both boundaries, to first order. It ends
/// for every input: late rounds leave out bits. In practice one to four rounds do. Laws: a region on the grid is not
/// changed; rounding the result again gives the result. Of each round O((n + k) log n) for k crossings; where edges are
/// snapped, O(n^2) at worst. Throws std::invalid_argument for a step that is none (CoordinateGrid) and for coordinates
/// beyond the largest number of the format; Cancelled. Source: iterated snap rounding (Halperin and Packer 2002), on
/// the numbers of the format; snap rounding (Hobby 1999).
[[nodiscard]] RoundedRegion round_to_region(const Region& region, const CoordinateGrid& grid = {},
                                            const Monitor& monitor = {});

/// A self-check for tests: the invariants of Region that do not hold, as sentences; empty for every region that a
/// function here returns. O(n log n).
[[nodiscard]] std::vector<std::string> validate(const Region& region);

/// Point-membership classification: in the interior, on the boundary, outside.
enum class Membership { in, on, out };

/// Locates points in a region. For the interior of a polyloop, take the region that it fills
/// (`fill`, by parity): its edges are those of the boundary L.b, not those that have the interior on both sides.
/// Holds a reference to the region. It must outlive the locator. Queries are const and thread-safe.
class Locator {
 public:
  explicit Locator(const Region& region);

  /// Exact for all finite points. Counts the edges to the left, at a height just above the point: no ray meets a
  /// vertex. O(segments in a strip).
  [[nodiscard]] Membership locate(const PlanePoint& p) const;
  [[nodiscard]] Membership locate(const RationalPlacement& p) const;

 private:
  struct Data;
  Shared<Data> data_;
};

/// A polygon of a region as one polyloop: every hole is joined to what lies to its left by a
/// bridge, an edge that is walked there and back, inside of the polygon and between two of its vertices. Its interior
/// by parity, `fill` with FillRule::even_odd, is the polygon again. Bridges lie on no given line, so vertices that are
/// no doubles are rationals of the result. O(holes * vertices). Source: Eberly, "Triangulation by Ear Clipping" for
/// which vertices see each other.
[[nodiscard]] Loops bridged(const Region& region, std::uint32_t polygon);

/// One polygon of a region as a region of its own.
[[nodiscard]] Region polygon_of(const Region& region, std::uint32_t polygon);

/// The canonical decomposition of the plane by a polygon S (Rossignac's SGC(S)): the face S, the exterior
/// faces, and the boundary's edges and vertices, which the polygon determines. A vertex is a boundary point around
/// which the boundary is no straight line; edges are the components of the rest. Labels: S true, all else false.
struct CanonicalDecomposition {
  struct Edge {
    std::uint32_t from = 0, to = 0;  ///< in `vertices`; S lies to the left
  };
  std::vector<RationalPlacement> vertices;  ///< in lexicographic order
  std::vector<std::uint32_t> degree;        ///< edges at every vertex: 2 where the polygon is manifold
  std::vector<Edge> edges;
  std::uint32_t exterior_faces = 1;  ///< the unbounded one, and one in every hole

  [[nodiscard]] bool is_manifold() const;
};

[[nodiscard]] CanonicalDecomposition canonical_decomposition(const Region& region, std::uint32_t polygon);

/// The relation of two regions.
enum class Relation {
  apart,        ///< their closures have no common point
  contact,      ///< their boundaries have, their interiors have not
  interfering,  ///< their interiors have
};

/// The contact region A.b n B.b of two regions that do not interfere: closed edges, as long as they go straight and
/// nothing else comes in, and isolated points. Both are exact, in lexicographic order.
struct Contact {
  Relation relation = Relation::apart;
  std::vector<std::array<RationalPlacement, 2>> edges;  ///< the lesser end first
  std::vector<RationalPlacement> points;
};

/// The contact of two regions; of interfering regions, the relation alone. O((n + k) log n).
[[nodiscard]] Contact contact_of(const Region& a, const Region& b);

/// File formats of polygons.
enum class PlanarFormat {
  wkt,      ///< POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION of these; coordinates may be quotients: 1/3
  geojson,  ///< Polygon, MultiPolygon, GeometryCollection, Feature, FeatureCollection
  svg,      ///< paths of straight lines: M L H V Z and m l h v z
};

/// By a file's extension (.wkt, .txt; .geojson, .json; .svg) or by a name ("wkt", "geojson", "svg"), in lower case.
[[nodiscard]] std::optional<PlanarFormat> planar_format_of(const FilePath& path);
[[nodiscard]] std::optional<PlanarFormat> planar_format_named(std::string_view name);

/// What a file holds: loops whose point set is that of the nonzero fill rule. Rings of polygons (WKT, GeoJSON) are
/// turned so that shells go counter-clockwise and holes clockwise, by the signs of their areas; paths (SVG) are as they
/// are. A repeated last vertex is left out.
struct PlanarFile {
  Loops loops;
  std::vector<std::string> notes;  ///< what was left out, one sentence each
};

/// Reads polygons; coordinates become their nearest doubles, quotients and sums of relative coordinates stay exact.
/// Of SVG, paths that are drawn where they stand; clip paths, fill rules and other shapes are reported in notes. A
/// byte order mark is ignored. Throws IoError: missing, unreadable or malformed files, other geometries, curves in
/// paths, and transformations. O(size of the file).
[[nodiscard]] PlanarFile read_planar(const FilePath& path, std::optional<PlanarFormat> format = {});
[[nodiscard]] PlanarFile read_planar(std::string_view data, PlanarFormat format, std::string name);

/// How coordinates are written that are not doubles.
enum class Coordinates {
  nearest,  ///< as the nearest doubles, in the shortest digits that read back the same
  exact,    ///< as quotients in lowest terms; WKT only
};

/// A region as text; negative zeros are zeros. Throws IoError for exact coordinates in formats that have none.
[[nodiscard]] std::string to_text(const Region& region, PlanarFormat format,
                                  Coordinates coordinates = Coordinates::nearest);
/// A region as path data of SVG, the attribute `d`: a line of text per loop.
[[nodiscard]] std::string svg_path(const Region& region);

}  // namespace strata::planar
