#pragma once
/// Queries of solids in space: point location, ray casting, visibility from an origin, and layer decompositions.
///
/// A Scene keeps the solids; all other classes are built from a scene. All are immutable values: copying is O(1),
/// reading is thread-safe. Answers are exact, and do not depend on the number of threads.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "strata/combine.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {

/// Solids in one numbering of vertices and faces, those of the first solid first. An immutable value.
class Scene {
 public:
  Scene() : Scene(std::vector<ExactMesh>{}) {}
  /// Requires closed meshes without degenerate faces, as solids have. Solids may touch, overlap and cross each other
  /// and themselves. Throws InputError where an index is out of range, a coordinate not finite or a face degenerate,
  /// naming the solid; std::length_error for more than 2^32 - 2 faces or vertices.
  explicit Scene(std::vector<ExactMesh> solids, const Monitor& monitor = {});

  [[nodiscard]] std::uint32_t solid_count() const;
  [[nodiscard]] std::uint32_t face_count() const;
  [[nodiscard]] const ExactMesh& solid(std::uint32_t i) const;
  [[nodiscard]] std::uint32_t solid_of(std::uint32_t face) const;  ///< the solid of a face of the scene; O(log solids)
  /// The number of a face within its solid.
  [[nodiscard]] std::uint32_t local(std::uint32_t face) const;

  /// The vertices of all solids in one numbering, those of the first solid first.
  [[nodiscard]] std::uint32_t vertex_count() const;
  [[nodiscard]] const Vertex& vertex(std::uint32_t v) const;    ///< nearest doubles
  [[nodiscard]] RationalPoint position(std::uint32_t v) const;  ///< exact
  /// The vertices of a face, counter-clockwise seen from outside. O(log solids).
  [[nodiscard]] Triangle face(std::uint32_t face) const;

  struct Data;                                               ///< internal
  [[nodiscard]] const Data& data() const { return *data_; }  ///< internal

 private:
  Shared<Data> data_;
};

/// The scene of some solids, numbered as they are listed: copies of their exact meshes. O(size of the meshes).
[[nodiscard]] Scene scene_of(std::span<const Solid> solids, const Monitor& monitor = {});

/// Where a point lies: outside of a closed set, on its boundary, or in its interior.
enum class Where : std::uint8_t { out, on, in };

/// A solid that a point lies on, and the lowest of its faces that it is on.
struct Contact {
  std::uint32_t solid = 0;
  std::uint32_t face = 0;  ///< of the scene

  friend bool operator==(const Contact&, const Contact&) = default;
};

/// The winding numbers of solids about a point, sparse: those that are 0 are left out.
class WindingNumbers {
 public:
  using Entry = std::pair<std::uint32_t, std::int32_t>;  ///< solid, winding number

  WindingNumbers() = default;
  /// Requires that entries are by increasing solid, and that no winding number is 0.
  explicit WindingNumbers(std::vector<Entry> entries) : entries_(std::move(entries)) {}

  /// 0 for solids that are not listed. O(log size).
  [[nodiscard]] std::int32_t operator[](std::uint32_t solid) const;
  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }
  friend bool operator==(const WindingNumbers&, const WindingNumbers&) = default;

 private:
  std::vector<Entry> entries_;
};

/// Where a point lies in a scene.
struct Location {
  WindingNumbers windings;        ///< of the solids that the point is not on
  std::vector<Contact> contacts;  ///< the solids that it is on, in order

  /// With respect to the union of all solids: `on` if the point is on a face of any of them; else `in` if a winding
  /// number is not zero.
  [[nodiscard]] Where where() const {
    if (!contacts.empty()) return Where::on;
    return windings.begin() == windings.end() ? Where::out : Where::in;
  }
};

/// Locates points in a scene. Space is divided into cells, each with an origin whose winding numbers are known; the
/// segment from there to a point of the cell crosses faces of the cell only, and their signs are added. In cells
/// without faces the origin's numbers are the answer. An immutable value.
/// Source: Feito and Torres 1997; lib/extensions/scene/theory.md, "Signed covering".
class Locator {
 public:
  /// O(n log n), in parallel; memory O(n) unless many faces are stacked on one another. Throws Cancelled.
  explicit Locator(Scene scene, const Monitor& monitor = {});

  [[nodiscard]] const Scene& scene() const;

  /// Whether q is in, on or outside of the union of the solids. Exact for finite coordinates. O(log n + faces near q),
  /// O(1) far from all faces. Cells are no smaller than 2^-30 of the scene: all faces within that count as near.
  [[nodiscard]] Where membership(const Vertex& q) const;
  /// The same for many points, in parallel. Requires as many answers as points.
  void membership(std::span<const Vertex> q, std::span<Where> answers) const;

  /// Which solids q is in, and on which faces it lies. Exact; the same cost.
  [[nodiscard]] Location locate(const Vertex& q) const;
  [[nodiscard]] std::vector<Location> locate(std::span<const Vertex> q) const;  ///< in parallel

  /// Bytes of memory, without the arrays of the scene.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Data;
  Shared<Data> data_;
};

/// The points from + t * direction, t >= 0. The direction is any finite vector but zero; its length is the unit of t.
struct Ray {
  Vertex from{}, direction{};
};

/// The points from + t * (to - from), 0 <= t <= 1, with the exact difference; both ends may be one point.
struct Segment {
  Vertex from{}, to{};
};

/// How a ray passes a solid at an event, by where the ray is just before and just after it:
///
/// | value    | before                | after                                                                   |
/// |----------|-----------------------|-------------------------------------------------------------------------|
/// | entering | out, or on            | in                                                                      |
/// | leaving  | in, or on             | out                                                                     |
/// | touching | out                   | out                                                                     |
/// | touching | in                    | in                                                                      |
/// | along    | any                   | on: the ray runs within a face or along an edge                         |
///
/// In a solid that overlaps itself, a greater winding number after the event is entering, a smaller one leaving, and
/// after a stretch on the surface any winding number but zero is in.
enum class Passage : std::uint8_t { entering, leaving, touching, along };

/// An event of a ray and a solid.
struct RayHit {
  Rational t;              ///< along the direction
  RationalPoint place;     ///< the position: from + t * direction
  Vertex rounded{};        ///< the nearest doubles
  std::uint32_t face = 0;  ///< of the scene: the solid's lowest face there
  std::uint32_t solid = 0;
  Passage passage = Passage::entering;

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// The same without the rationals.
struct RoundedHit {
  double t = 0;    ///< nearest double; infinite beyond the largest
  Vertex place{};  ///< nearest doubles
  std::uint32_t face = 0;
  std::uint32_t solid = 0;
  Passage passage = Passage::entering;

  friend bool operator==(const RoundedHit&, const RoundedHit&) = default;
};

/// Exact ray queries over a scene, from any point.
///
/// The events of a solid along a ray are the parameters at which the ray meets the solid's closed faces, edges and
/// corners included, and both ends of a stretch within a face; equal parameters of one solid are one event. A ray that
/// starts on a surface has an event at 0; its passage compares the ray with the part of its line just before the start.
/// Events come by increasing parameter, equal ones by number of the solid. Laws: positions do not depend on the
/// direction's length; a moved or scaled scene and ray (where that is exact) have the same events; events do not depend
/// on how facets are triangulated, but for the face numbers, and for events between two stretches along.
///
/// Requires closed solids, as a Scene does. An immutable value, safe to ask from many threads; batches run in parallel
/// and answer the same for any number of threads. All throw std::invalid_argument for a zero direction and for
/// coordinates that are not finite. Exact at any scale: the answers are signs and rationals. A query is O(log n + faces
/// near the ray) in the usual case.
class RayCaster {
 public:
  /// O(n log n), in parallel. The scene is shared, not copied.
  explicit RayCaster(Scene scene);

  [[nodiscard]] const Scene& scene() const;

  /// The first event of all solids; nothing if the ray meets none.
  [[nodiscard]] std::optional<RayHit> first(const Ray& ray) const;
  [[nodiscard]] std::optional<RoundedHit> first_rounded(const Ray& ray) const;

  /// All events of all solids.
  [[nodiscard]] std::vector<RayHit> all(const Ray& ray) const;
  [[nodiscard]] std::vector<RoundedHit> all_rounded(const Ray& ray) const;

  /// True when the closed segment meets any closed face; false for a segment in the interior of a solid.
  [[nodiscard]] bool any(const Segment& segment) const;

  [[nodiscard]] std::vector<std::optional<RayHit>> first(std::span<const Ray> rays) const;
  [[nodiscard]] std::vector<std::vector<RayHit>> all(std::span<const Ray> rays) const;
  /// Requires as many answers as rays or segments.
  void first_rounded(std::span<const Ray> rays, std::span<std::optional<RoundedHit>> answers) const;
  void all_rounded(std::span<const Ray> rays, std::span<std::vector<RoundedHit>> answers) const;
  void any(std::span<const Segment> segments, std::span<bool> answers) const;

  struct Data;                                               ///< internal
  [[nodiscard]] const Data& data() const { return *data_; }  ///< internal

 private:
  Shared<Data> data_;
};

/// The point of view: a point, from which rays run in all directions, or a direction, along which parallel rays run.
struct Origin {
  enum class Kind { point, direction };

  Kind kind = Kind::point;
  Vertex at{};  ///< the point, or the direction of the rays (not zero, of any length)

  static Origin point(const Vertex& p) { return {Kind::point, p}; }
  static Origin direction(const Vertex& d) { return {Kind::direction, d}; }

  [[nodiscard]] bool is_point() const { return kind == Kind::point; }
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// A point from which the scene is likely to have few layers and few cuts, and that lies on no plane of a face, which
/// is checked exactly: no face is flat. The same for any number of threads.
///
/// A heuristic: a few positions inside and outside are compared by the number of faces one behind the other on sampled
/// rays, in doubles. The best one then moves by small exact steps until it is on no plane. For an empty scene it is (0,
/// 0, 0). O(vertices + faces), a small part of the cost of a decomposition.
/// Throws std::invalid_argument if all steps are on planes, which takes planes that fill the range of doubles.
[[nodiscard]] Origin choose_origin(const Scene& scene);

/// The faces of a scene in layers as seen from an origin (after Rueda, Feito, Ortega, "Layer-based decomposition of
/// solids"). A face dominates another one if it comes later on some ray from the origin. Layer 1 has the faces that
/// nothing dominates, which are the farthest along all their rays; every other face is in the layer after the last one
/// of those that dominate it. Going through the layers from the first to the last is the painter's order, back to
/// front.
///
/// Faces that cross are cut along each other, and cycles of faces that dominate one another are broken by cuts; the
/// parts are numbered after the faces. Faces whose planes contain the origin ("flat") are in no layer: no ray meets
/// their interiors. Faces that overlap in one plane do not dominate each other. An immutable value.
class LayerDecomposition {
 public:
  /// O((n + k) log n) in n faces and k pairs of faces that are seen in one square of directions. Throws
  /// std::invalid_argument (an origin that is not finite, or a direction 0), Cancelled.
  LayerDecomposition(Scene scene, const Origin& origin, const Monitor& monitor = {});

  [[nodiscard]] const Scene& scene() const;
  [[nodiscard]] const Origin& origin() const;

  [[nodiscard]] std::uint32_t layer_count() const;
  /// The number of faces and parts of faces, those that were cut included.
  [[nodiscard]] std::uint32_t piece_count() const;
  /// From 1; 0 for flat faces and for pieces that were cut into parts.
  [[nodiscard]] std::uint32_t layer(std::uint32_t piece) const;
  [[nodiscard]] bool is_replaced(std::uint32_t piece) const;       ///< it was cut into parts, which stand for it
  [[nodiscard]] std::uint32_t face_of(std::uint32_t piece) const;  ///< the face of the scene that it is a part of
  /// Exact; corners made by cuts are rationals. Counter-clockwise seen from outside.
  [[nodiscard]] std::array<RationalPoint, 3> triangle(std::uint32_t piece) const;
  /// The sign of a piece's tetrahedron: +1 when the outward normal points away from the origin, -1 when towards it, 0
  /// when flat.
  [[nodiscard]] int sign(std::uint32_t piece) const;
  /// The winding numbers of the solids beside the origin: none where it is outside of all.
  [[nodiscard]] WindingNumbers windings_of_origin() const;

  /// The pieces of a layer, 1 to layer_count(), by increasing number.
  [[nodiscard]] std::span<const std::uint32_t> layer_pieces(std::uint32_t layer) const;
  /// All pieces back to front: those of the first layer, then the second's, ...
  [[nodiscard]] std::span<const std::uint32_t> back_to_front() const;
  /// Pieces that dominate this one, by increasing number: at least those that are the next behind it on some ray.
  [[nodiscard]] std::span<const std::uint32_t> dominators(std::uint32_t piece) const;

  [[nodiscard]] std::uint32_t cuts_at_crossings() const;
  [[nodiscard]] std::uint32_t cuts_of_cycles() const;
  [[nodiscard]] std::uint64_t domination_count() const;
  [[nodiscard]] std::uint64_t pairs_tested() const;
  /// Bytes of memory, without the arrays of the scene.
  [[nodiscard]] std::size_t bytes() const;

  /// A self-check for tests: the invariants that do not hold, as sentences; empty if all do. Every dominator is in a
  /// lower layer, every piece is in the layer after its last dominator, and at `samples` points the winding numbers
  /// from the signed covering equal those counted along a ray. O(n + k) and O(n) per sample.
  [[nodiscard]] std::vector<std::string> validate(std::size_t samples = 16) const;

  struct Data;                                               ///< internal
  [[nodiscard]] const Data& data() const { return *data_; }  ///< internal

 private:
  Shared<Data> data_;
};

/// The regularized Boolean of two solids, each given by its layers about a common origin, in layers: faces that meet
/// are split along each other, each piece is kept or dropped by the winding numbers that the two signed coverings give,
/// and what is kept is sorted into layers. The result is solid 0 of its scene; as a point set it does not depend on the
/// origin. Of the options `threads`, `progress` and `cancel` count. Throws std::invalid_argument (different origins,
/// not one solid each), Cancelled.
[[nodiscard]] LayerDecomposition combine(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                                         const Options& options = {});

/// Computes `combine` by layers (Options::engine): winding numbers come from the signed coverings of all operands about
/// one common origin (`choose_origin`), in place of the cells of the arrangement. Faces are split along each other by
/// the same exact predicates. Throws what `combine` and `choose_origin` throw. Source: Rueda, Feito, Ortega,
/// "Layer-based decomposition of solids".
extern const Engine layer_engine;

/// A convex polygon within a face, counter-clockwise as the face is.
using ExactPolygon = std::vector<RationalPoint>;

/// A part of an edge from a to b: all points a + t (b - a) with from <= t <= to.
struct Stretch {
  Rational from, to;
};

/// What is seen of a scene of opaque faces from the origin of its decomposition, exactly.
///
/// A point inside a face is hidden when another face comes before it on its ray. A point of an edge is seen when it is
/// a limit of seen points of one of the edge's faces; so edges that coincide in the view, as is frequent in views along
/// an axis, are hidden or not by what lies on their own side. Faces whose planes contain the origin are not seen.
///
/// Faces may cross each other. An immutable value. Source: lib/extensions/scene/theory.md.
class Visibility {
 public:
  explicit Visibility(LayerDecomposition decomposition);

  [[nodiscard]] const LayerDecomposition& decomposition() const;

  /// The seen parts of the edge from a to b, vertices of `face`, as a side of that face; in order, disjoint. O(k log k)
  /// for k faces before the face.
  [[nodiscard]] std::vector<Stretch> seen_along(std::uint32_t face, std::uint32_t a, std::uint32_t b) const;

  /// The seen region of a face as convex polygons with disjoint interiors; empty when nothing is seen.
  [[nodiscard]] std::vector<ExactPolygon> seen_region(std::uint32_t face) const;

  /// The faces of which something is seen, by increasing number. In parallel.
  [[nodiscard]] std::vector<std::uint32_t> seen_faces() const;

 private:
  struct Data;
  Shared<Data> data_;
};

/// Why an edge is drawn.
enum class EdgeKind : std::uint8_t {
  loop,    ///< a silhouette: in the view its faces are on one side only, or a front face and a back face meet
  crease,  ///< two faces meet at an angle, or more than two faces meet
};

/// An edge of a scene with the parts of it that are seen.
struct SeenEdge {
  std::uint32_t a = 0, b = 0;  ///< vertices of the scene, a < b
  EdgeKind kind = EdgeKind::loop;
  std::vector<Stretch> seen;  ///< in order
};

/// The edges that a line drawing shows, by increasing vertices: silhouettes, and creases whose faces' normals differ by
/// more than an angle in degrees, which is a matter of style and measured in doubles. Edges within a plane are left
/// out, exactly. Which parts of the edges are seen is exact. In parallel.
/// Throws Cancelled.
[[nodiscard]] std::vector<SeenEdge> find_seen_edges(const Visibility& visibility, double crease_angle,
                                                    const Monitor& monitor = {});

}  // namespace strata
