#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/arrange/face_points.h"
#include "core/arrange/path_polygons.h"
#include "core/overlap/constraint.h"

namespace strata {

/// A triangulation of one input face that contains symbolic points and constraint segments, exactly.
///
/// Points are inserted by exact location, so points with different names that coincide are found and recorded as equal.
/// Segments are inserted by walking. Where two cross, their common point is named and inserted. Where they overlap, an
/// edge carries both. The resulting pieces meet only along shared vertices and edges. The triangles have short
/// diagonals, compared in doubles; every choice is correct.
/// Source: Sloan 1993 (insertion of edges by flips); theory.md.
class Triangulation {
 public:
  /// A triangle: vertices counter-clockwise in the face's projection; side i runs from v[i] to v[i + 1].
  struct Triangle {
    std::array<std::int32_t, 3> v;  ///< local vertices
    std::array<std::int32_t, 3> n;  ///< triangle across side i, or -1 on the boundary of the face
    std::array<std::int32_t, 3> c;  ///< constraints on side i: the first of a list, or -1
  };
  /// One constraint on a side: its index as given, and whether the side runs along tail -> head.
  struct Note {
    std::int32_t constraint = 0;
    bool forward = true;
    std::int32_t next = -1;
  };
  struct Location {
    std::int32_t triangle = -1;
    enum class On : std::uint8_t { inside, side, vertex } on = On::inside;
    int index = 0;  ///< of the side or vertex in the triangle
  };

  Triangulation(const InputComplex& input, const PointTable& table)
      : input_(input), points_(input, table), paths_(input, points_) {}
  Triangulation(const Triangulation&) = delete;
  Triangulation& operator=(const Triangulation&) = delete;

  /// What the names of points passed to `add_point` show about the face's own edges.
  enum class Names : std::uint8_t {
    any,     ///< nothing
    lowest,  ///< a point whose name contains this face is in its interior; one whose name contains an edge of this face
             ///< is inside that edge
  };

  /// Starts again with one triangle: the face itself, its corners being local vertices 0, 1, 2.
  void start(std::uint32_t face, Names names);

  /// The polygons into which the constraints divide the face, right after `start`, if they are simple paths through it,
  /// as where two surfaces only cross: constraint i has the number i. Then `fill` makes the triangles. Else null, and
  /// the triangulation is as after `start`. Requires names of the lowest features.
  const PathPolygons* find_paths(std::span<const Constraint> constraints);

  /// Fills one of these polygons with triangles. Returns false where that fails, since it is large or paths cross each
  /// other; `start` has to be called again. Paths that cross are noticed when all polygons are filled, not before.
  bool fill(std::size_t polygon) { return cut_ears(paths_[polygon]); }

  /// Inserts the ends of all constraints, then those that are segments: constraint i gets the number i.
  void add_constraints(std::span<const Constraint> constraints);

  /// Local vertex of a point. The point is inserted if no vertex has its position. Requires a point of the closed face.
  std::int32_t add_point(PointId id);

  /// Records a name that was found to be a vertex, too.
  struct OtherName {
    std::int32_t vertex = 0;
    SymbolicPoint name;
  };

  /// Inserts a segment between two local vertices as constraint number `constraint`, carried by `line`.
  void add_segment(std::int32_t tail, std::int32_t head, std::int32_t constraint, const ConstraintLine& line);

  /// Flips diagonals beside triangles with an angle of nearly 180 degrees, as long as fewer of these are left: rounding
  /// turns them over. Angles are computed in doubles; every choice is correct. No polygon is filled afterwards. O(n).
  void avoid_flat_angles();

  /// Reports, for every vertex in which lines of different faces' operands meet, the names that those lines give it. A
  /// point found under one name here may have another name in the faces that carry those lines. `same_operand`: lines
  /// of one operand count as well. Only vertices for which `wanted` is not negative are reported.
  void connect_names(bool same_operand, std::span<const std::int32_t> wanted);

  /// Location of a point of the closed face.
  [[nodiscard]] Location locate(const Point& p);

  [[nodiscard]] std::uint32_t face() const { return points_.face(); }
  [[nodiscard]] const FacePoints& points() const { return points_; }
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] const Note& note(std::int32_t i) const { return notes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::span<const Note> notes() const { return notes_; }
  /// Some triangle at a vertex.
  [[nodiscard]] std::int32_t triangle_at(std::int32_t vertex) const { return at_[static_cast<std::size_t>(vertex)]; }
  /// The names of vertices beside their own.
  [[nodiscard]] std::span<const OtherName> other_names() const { return other_names_; }

 private:
  struct Side {
    std::int32_t triangle = -1;
    int index = 0;
  };
  using Corners = std::array<std::int32_t, 3>;
  /// The first step of a segment that leaves a vertex.
  struct Departure {
    Side side;                 ///< the side it crosses, if it does
    std::int32_t vertex = -1;  ///< else the vertex it reaches along a side
  };

  [[nodiscard]] Sign orientation(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return points_.orientation(a, b, c);
  }
  [[nodiscard]] Sign inner_side(Side s, std::int32_t p) const;
  [[nodiscard]] Location locate(std::int32_t vertex);
  std::int32_t new_vertex(const Point& p);
  void drop_vertex();

  [[nodiscard]] Triangle& tri(std::int32_t t) { return triangles_[static_cast<std::size_t>(t)]; }
  [[nodiscard]] const Triangle& tri(std::int32_t t) const { return triangles_[static_cast<std::size_t>(t)]; }
  [[nodiscard]] Side partner(Side s) const;
  [[nodiscard]] int index_of(std::int32_t triangle, std::int32_t vertex) const;
  [[nodiscard]] Side find_side(std::int32_t a, std::int32_t b) const;
  void link(std::int32_t t, int i, std::int32_t u);
  void split_triangle(std::int32_t t, std::int32_t v);
  void split_side(Side s, std::int32_t v);
  void flip(Side s);
  [[nodiscard]] bool is_flippable(Side s) const;
  void improve(std::int32_t vertex);
  [[nodiscard]] bool prefers_flip(Side s) const;
  [[nodiscard]] bool has_flat_angle(const Corners& corners) const;
  [[nodiscard]] bool leaves_fewer_flat(Side s) const;

  /// A side of the polygon from which ears are cut.
  struct PolygonSide {
    PathPolygons::Side side;        ///< with its constraint or edge, unless
    Side inner;                     ///< a triangle is already there
    Sign orientation = Sign::zero;  ///< at `from`, if known
    bool orientation_known = false;
  };
  bool cut_ears(std::span<const PathPolygons::Side> sides);
  [[nodiscard]] bool is_straight(std::size_t i) const;
  [[nodiscard]] bool crosses_one_plane(std::size_t i) const;
  [[nodiscard]] Sign corner_orientation(std::size_t i);
  [[nodiscard]] bool is_ear(std::size_t i);
  void cut_ear(std::size_t i);
  std::int32_t new_triangle(std::int32_t a, std::int32_t b, std::int32_t c);
  void attach(Side s, const PolygonSide& given);
  [[nodiscard]] double squared_length(std::int32_t a, std::int32_t b) const;

  [[nodiscard]] Departure depart(std::int32_t from, std::int32_t to) const;
  std::int32_t advance(std::int32_t from, std::int32_t to, const ConstraintLine& line);
  void open_way(std::int32_t from, std::int32_t to, std::vector<std::pair<std::int32_t, std::int32_t>>& crossed);
  std::int32_t cross_constraint(Side s, const ConstraintLine& line);
  [[nodiscard]] SymbolicPoint name_of_crossing(const ConstraintLine& a, const ConstraintLine& b) const;
  [[nodiscard]] std::uint32_t operand_of(const ConstraintLine& line) const;
  void mark(std::int32_t from, std::int32_t to, std::int32_t constraint);
  void add_note(Side s, std::int32_t constraint, bool forward);

  const InputComplex& input_;
  Names given_names_ = Names::any;
  FacePoints points_;
  PathPolygons paths_;
  std::vector<PolygonSide> polygon_;
  std::vector<const SourcePlane*> crossed_planes_;  ///< per constraint, if any are known
  std::vector<Side> halves_;                        ///< per constraint: triangles' sides backward and forward along it
  std::vector<Triangle> triangles_;
  std::vector<std::int32_t> at_;
  std::vector<Note> notes_;
  std::vector<ConstraintLine> lines_;  ///< per constraint number
  std::vector<OtherName> other_names_;
  std::vector<std::pair<std::int32_t, std::int32_t>> crossed_;
  std::vector<std::pair<std::int32_t, std::int32_t>> ends_;  ///< of the constraints that are added
  std::vector<std::int32_t> stack_;                          ///< triangles whose sides are to be tested
  std::int32_t last_ = 0;
};

}  // namespace strata
