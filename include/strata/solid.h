#pragma once
/// Solids as values: made from meshes, combined, moved, split, measured.
///
///   const Solid part = make_box({0, 0, 0}, {4, 4, 2}) - make_cylinder(1, 2, 64).translated({2, 2, 0});
#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "strata/attributes.h"
#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/plane.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/transform.h"

namespace strata {

/// An axis-parallel box. That of the empty solid has lower = (inf, inf, inf) and upper = (-inf, -inf, -inf).
struct BoundingBox {
  Vertex lower;
  Vertex upper;
};

/// A bounded, closed, regular solid (equal to the closure of its interior), given by its boundary: a triangle mesh with
/// winding number 1 inside and 0 outside. It may have cavities and several components, and touch itself in edges and
/// vertices. The empty set is a solid.
///
/// Vertices are doubles or, where operations made them, rationals: results are exact operands in turn, however long a
/// chain of operations is. (Rationals grow with its length; an Expression evaluates a chain at once.)
///
/// An immutable value: copying is O(1), reading is thread-safe.
class Solid {
 public:
  Solid();  ///< the empty solid
  /// The solid that a mesh bounds, as InputClass says what is expected of it and what is resolved. Throws InputError
  /// with all defects where the mesh is not what it should be.
  /// O(n) for class `solid`; that of `check` for a solid of class `automatic`; that of a union for the others.
  explicit Solid(Mesh mesh, InputClass input = InputClass::automatic);
  /// The same for rational vertices, which are taken as they are: nothing is repaired.
  explicit Solid(ExactMesh mesh, InputClass input = InputClass::automatic);
  /// The same, watched. Of the options `input`, `most_hole_edges`, `threads`, `progress` and `cancel` count. Throws
  /// Cancelled, too.
  Solid(Mesh mesh, const Options& options);
  Solid(ExactMesh mesh, const Options& options);

  /// Of a mesh that is known to bound a solid, such as a result of Strata: nothing is checked. If it does not bound
  /// one, results are unspecified. O(n).
  [[nodiscard]] static Solid trusted(ExactMesh mesh);
  /// The same, with the source of each triangle.
  [[nodiscard]] static Solid trusted(ExactMesh mesh, std::vector<Source> sources);

  [[nodiscard]] const Mesh& mesh() const;             ///< coordinates rounded to the nearest doubles
  [[nodiscard]] const ExactMesh& exact_mesh() const;  ///< the same triangles with exact vertices
  /// Per triangle the operand, and the face of its mesh, that it is a part of, in the operation that made the solid.
  /// Of a solid made from a mesh operand 0 and the face's own number.
  [[nodiscard]] const std::vector<Source>& sources() const;
  [[nodiscard]] const std::vector<Defect>& notes() const;  ///< what was resolved when it was made

  /// What the mesh carries: channels of as many values as it has vertices, corners and faces. Solids made from solids
  /// have what these carry, as carry_attributes.h says; others have none. Solids are equal whatever they carry.
  [[nodiscard]] const Attributes& attributes() const;
  /// The same solid with these attributes in place of its own. Throws std::invalid_argument where they do not fit the
  /// mesh, as `check_attributes` says.
  [[nodiscard]] Solid with_attributes(Attributes attributes) const;

  [[nodiscard]] Rational volume() const;           ///< exact; O(n)
  [[nodiscard]] double area() const;               ///< of the boundary, to a few units in the last place; O(n)
  [[nodiscard]] BoundingBox bounding_box() const;  ///< of the rounded mesh; O(n)
  [[nodiscard]] bool is_empty() const;             ///< O(1)
  /// Does not depend on the triangulation. O(n log n).
  [[nodiscard]] CanonicalForm canonical(const Monitor& monitor = {}) const;

  /// The image under an affine map, with the sources of this solid. Placement::exact: exact, and a solid whatever the
  /// map. Placement::rounded: vertices are doubles; it is checked as by the constructor from a Mesh, which throws
  /// InputError where rounding turned the solid inside out, but a thin part may come to cross itself, which `check`
  /// finds. Law: the volume is multiplied by |det|, if exact. O(n). Throws std::overflow_error where a coordinate is
  /// beyond all doubles.
  [[nodiscard]] Solid transformed(const Transform& map, Placement placement = Placement::exact,
                                  const Monitor& monitor = {}) const;
  /// Moved, scaled about the origin (by a factor per axis, or one for all), mirrored in a plane through the origin or
  /// in any plane, rotated about an axis through the origin: `transformed` by the maps of these names, exactly. Throws
  /// std::invalid_argument for a factor, normal or quaternion 0.
  [[nodiscard]] Solid translated(const RationalPoint& by) const;
  [[nodiscard]] Solid scaled(const RationalPoint& factors) const;
  [[nodiscard]] Solid scaled(const Rational& factor) const;
  [[nodiscard]] Solid mirrored(const RationalPoint& normal) const;
  [[nodiscard]] Solid mirrored(const Plane& plane) const;
  [[nodiscard]] Solid rotated(const Quaternion& by) const;
  /// About an axis of any length through the origin, by an angle in degrees, counter-clockwise as seen from the axis's
  /// end. Exact for quarter and half turns about coordinate axes. Otherwise the angle is that of the nearest doubles
  /// (Quaternion::of_angle), and vertices are rounded to doubles, as Placement::rounded says; Placement::exact keeps
  /// the solid congruent to this one, with rationals of some 200 bits.
  [[nodiscard]] Solid rotated(const std::array<double, 3>& axis, double degrees,
                              Placement placement = Placement::rounded) const;

  struct Halves;
  /// What is behind a plane and what is in front of it, both regularized; exact for a solid and a plane in any
  /// position. Laws: the volumes add up to this one's; the halves share their section in the plane, and their union is
  /// this solid. A solid on one side of the plane, even if it touches it, is one half as it is, and the other half is
  /// empty. Sources: operand 0 is this solid; operand 1 is the plane, whose face numbers mean nothing. O(n) to find
  /// that nothing is cut, else two Booleans with a prism of 12 faces. Throws std::invalid_argument for a normal 0,
  /// Cancelled, and std::overflow_error where the prism is beyond all doubles (coordinates above 2^1000).
  [[nodiscard]] Halves split(const Plane& plane, const Options& options = {}) const;

  /// The connected components of the interior, each as a solid with all of its cavities: parts that only touch, in
  /// edges or vertices, are components of their own, and so is a solid within a cavity of another. Components come in
  /// the order of their first triangles and keep the order of triangles, the vertices and the sources. Laws: volumes
  /// add up; components have no common interior points; each is connected: it is its only component. The empty solid
  /// has none. Requires that the boundary meets itself in common vertices and edges only, as in results of operations,
  /// and as `check` finds; parts of other solids may come out joined. Exact. O(n log n), and for every cavity the faces
  /// that a line through it meets.
  [[nodiscard]] std::vector<Solid> components() const;

  /// This solid and its cavities, with what is inside them: all that it closes off from infinity. What is connected to
  /// the outside in edges or vertices only is closed off. Sources are those of this solid. Laws: it contains this
  /// solid; it is its own; the exterior is connected. The same requirement as `components`. Exact. O(n log n); where
  /// there is a solid within a cavity, that of a union.
  [[nodiscard]] Solid without_cavities(const Options& options = {}) const;

  /// This solid with edges and vertices of its own for every sheet of the boundary: where the solid touches itself in
  /// an edge or a vertex, each wedge of its interior has its own copies. Every edge then has two triangles, and the
  /// triangles of every vertex form one fan: the mesh is a 2-manifold. (Otherwise what sheets share is listed once.)
  /// Where wedges at an edge are connected around both of its ends, copies of the edge would have the same ends: they
  /// are divided in the middle. Triangles keep their order and sources, vertices their numbers; copies and
  /// parts of divided triangles come last. Laws: equal to this solid as a point set; separating twice is separating
  /// once. Requires what `components` requires. Exact. O(n log n).
  [[nodiscard]] Solid separated() const;

  /// Equal as point sets, exactly; triangulations do not matter. O(1) for copies, else O(n log n).
  friend bool operator==(const Solid& a, const Solid& b);

  struct Data;  ///< internal

 private:
  explicit Solid(Shared<Data> data);
  friend Solid combine_solids(Operation, std::span<const Solid>, const Options&);
  friend Solid combine_solids(const Formula&, std::span<const Operand>, const Options&);
  friend Solid resolve(ExactMesh, Inside, const Options&);
  Shared<Data> data_;
};

/// The two parts of a solid that a plane divides: `const auto [behind, in_front] = solid.split(plane);`
struct Solid::Halves {
  Solid behind;    ///< normal . p <= offset
  Solid in_front;  ///< normal . p >= offset
};

/// The regularized Boolean of any number of solids, in one arrangement: faster than one after the other. Of no solids:
/// the empty solid. Exact; `combine` says what the result looks like and what is thrown. Of the options the class of
/// input and `exact_vertices` are ignored: solids are solids, and results are exact.
[[nodiscard]] Solid combine_solids(Operation operation, std::span<const Solid> operands, const Options& options = {});
[[nodiscard]] Solid combine_solids(Operation operation, std::initializer_list<Solid> operands,
                                   const Options& options = {});

/// The solid of the points for which a formula about operands holds. Throws as `combine` does.
[[nodiscard]] Solid combine_solids(const Formula& formula, std::span<const Operand> operands,
                                   const Options& options = {});

/// The same by name: `union_({a, b, c})`, or of a vector. Laws: those of sets, as point sets.
[[nodiscard]] Solid union_(std::span<const Solid> operands);
[[nodiscard]] Solid union_(std::initializer_list<Solid> operands);
[[nodiscard]] Solid intersection(std::span<const Solid> operands);
[[nodiscard]] Solid intersection(std::initializer_list<Solid> operands);
[[nodiscard]] Solid difference(std::span<const Solid> operands);  ///< the first minus all others
[[nodiscard]] Solid difference(std::initializer_list<Solid> operands);
[[nodiscard]] Solid symmetric_difference(std::span<const Solid> operands);  ///< in an odd number
[[nodiscard]] Solid symmetric_difference(std::initializer_list<Solid> operands);

[[nodiscard]] Solid operator|(const Solid& a, const Solid& b);  ///< union
[[nodiscard]] Solid operator&(const Solid& a, const Solid& b);  ///< intersection
[[nodiscard]] Solid operator-(const Solid& a, const Solid& b);  ///< difference
[[nodiscard]] Solid operator^(const Solid& a, const Solid& b);  ///< symmetric difference

}  // namespace strata
