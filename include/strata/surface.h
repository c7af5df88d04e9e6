#pragma once
/// Surfaces that need not be closed: cut by solids, imprinted on one another, dividing solids and space.
///
///   const std::vector<Solid> layers = split(rock, std::vector{horizon, fault});
///   const Surface inside = clip(terrain, building, ClipTo::inside);
///
/// All functions are exact, give the same result for any number of threads, and may be called from many threads at
/// once. Of the options they use `threads`, `progress` and `cancel`. They throw Cancelled, and std::length_error for
/// more than 2^32 - 2 vertices or faces. Complexity: O(n log n), and the pairs of faces whose boxes meet in small cells
/// of space, for n faces in and out; in parallel but for the order of faces around edges.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/attributes.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/plane.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {

/// A set of triangles in space. They need not be closed, oriented alike or connected; they may cross, touch and cover
/// one another. The empty set is a surface. An immutable value: copying is O(1), reading is thread-safe.
class Surface {
 public:
  Surface();  ///< without triangles
  /// Of a mesh. Vertices at one position become one, -0 becomes 0; triangles without area, which are no surface, are
  /// left out, with a note. Throws InputError for indices out of range and coordinates that are not finite. O(n).
  explicit Surface(const Mesh& mesh, const Monitor& monitor = {});
  /// The same with rational vertices. Throws std::invalid_argument where the doubles are not the nearest ones.
  explicit Surface(const ExactMesh& mesh, const Monitor& monitor = {});
  /// The boundary of a solid, with its attributes.
  explicit Surface(const Solid& solid);
  /// A rectangle of a plane that reaches beyond a box on all sides, seen counter-clockwise from in front: what cuts the
  /// plane out of anything within the box. Throws std::invalid_argument for a normal 0, std::overflow_error where the
  /// rectangle is beyond all doubles.
  [[nodiscard]] static Surface of_plane(const Plane& plane, const BoundingBox& around);

  [[nodiscard]] const Mesh& mesh() const;             ///< coordinates rounded to the nearest doubles
  [[nodiscard]] const ExactMesh& exact_mesh() const;  ///< the same triangles with exact vertices
  /// Per triangle the operand, and its face, that it is a part of, in the operation that made the surface. Of a surface
  /// made from a mesh operand 0 and the face's own number.
  [[nodiscard]] const std::vector<Source>& sources() const;
  [[nodiscard]] const std::vector<Defect>& notes() const;  ///< what was left out when it was made
  /// What the surface carries. What is made from surfaces here carries on what these do, as carry_attributes.h says.
  [[nodiscard]] const Attributes& attributes() const;
  /// The same surface with these attributes in place of its own. Throws std::invalid_argument where they do not fit
  /// mesh(), as `check_attributes` says. Attributes of the mesh that the surface was made from are led here by
  /// `carry_attributes` and sources().
  [[nodiscard]] Surface with_attributes(Attributes attributes) const;
  [[nodiscard]] bool is_empty() const;  ///< O(1)
  [[nodiscard]] double area() const;    ///< of all triangles, to a few units in the last place; O(n)

  struct Data;  ///< internal

 private:
  explicit Surface(Shared<Data> data);
  friend Surface surface_of(ExactMesh, std::vector<Source>);
  Shared<Data> data_;
};

/// The arrangement of surfaces: all of them, divided at their intersections into walls, and the cells into which the
/// walls divide space.
///
/// A wall is a triangle that is part of one face or of several that coincide there; walls have whole edges and vertices
/// in common, and nothing else. It has the orientation of the first face that it is part of; its front is where it is
/// seen counter-clockwise. Cells are open, connected, pairwise disjoint; with the walls they fill space. Cell 0 is the
/// unbounded one; the others come in the order of their first walls. A wall that ends inside a cell has this cell on
/// both sides.
///
/// Faces are numbered as in Surface::mesh() here, and in all results below; Surface::sources() leads back to the mesh
/// that the surface was made from.
struct Arrangement {
  /// Another face that a wall is part of.
  struct Cover {
    std::uint32_t wall = 0;
    Source face;
    bool is_reversed = false;  ///< it is oriented against the wall
  };

  ExactMesh mesh;                                   ///< the walls
  std::vector<Source> sources;                      ///< per wall: the first face that it is part of
  std::vector<Cover> covers;                        ///< by wall, then by operand and face
  std::vector<std::array<std::uint32_t, 2>> cells;  ///< per wall: the cell in front of it, the cell behind it
  std::uint32_t cell_count = 1;

  /// The bounded cells as solids: their closures. Number i is cell i + 1. Sources are those of the walls; walls inside
  /// a cell are not in its boundary. They carry no attributes (`cells_of` does). Laws: solids have no common interior
  /// points; each is connected.
  [[nodiscard]] std::vector<Solid> solids() const;
  /// Per cell, how often an operand winds around its points. Throws std::invalid_argument where the operand is not
  /// closed, so that this has no meaning: where a wall contradicts. O(walls).
  [[nodiscard]] std::vector<std::int32_t> windings(std::uint32_t operand) const;
};

/// The arrangement of any number of surfaces.
[[nodiscard]] Arrangement arrange(std::span<const Surface> surfaces, const Options& options = {});

/// The bounded cells of the arrangement of surfaces, closed or not: every volume that they enclose together, as a
/// solid. Law: where the surfaces are boundaries of solids, these unite to the union of the solids and the cavities
/// between them.
/// A cell's boundary carries what the surfaces do; where several coincide, the first one speaks.
[[nodiscard]] std::vector<Solid> cells_of(std::span<const Surface> surfaces, const Options& options = {});
/// The same of their arrangement, if it is there already.
[[nodiscard]] std::vector<Solid> cells_of(const Arrangement& arrangement, std::span<const Surface> surfaces,
                                          const Options& options = {});

/// The pieces into which surfaces divide a solid. Surfaces that end inside it, or leave a way around them, do not
/// divide it there. Sources: operand 0 is the solid, operand k surface k - 1. Laws: the pieces unite to the solid;
/// their volumes add up to its own; each is connected. Without surfaces: the components. Of the empty solid: none.
/// The attributes of all are carried; faces that the surfaces cut are cut faces (Options::cut_material).
[[nodiscard]] std::vector<Solid> split(const Solid& solid, std::span<const Surface> surfaces,
                                       const Options& options = {});

/// Which part of a surface a solid keeps.
enum class ClipTo {
  inside,   ///< in its interior
  outside,  ///< in its exterior
  on        ///< in its boundary
};

inline constexpr std::array all_clips{ClipTo::inside, ClipTo::outside, ClipTo::on};

/// As it is written on the command line: inside, outside, on.
[[nodiscard]] constexpr const char* name(ClipTo part) {
  constexpr std::array names{"inside", "outside", "on"};
  return names[static_cast<std::size_t>(part)];
}

/// The part of a surface inside, outside or on a solid, closed: with its edges. Sources: operand 0 is the surface.
/// Parts that the surface covers more than once are there once, and triangles are divided where the surface crosses
/// itself. Law: the three parts have no common area, and are together the surface.
[[nodiscard]] Surface clip(const Surface& surface, const Solid& solid, ClipTo part, const Options& options = {});

/// Each surface with the traces of the others, and its own, as edges: nothing is added or removed, but what a surface
/// covers more than once is there once. Where two surfaces coincide they have the same triangles. Sources: operand k is
/// surface k. Law: results have whole edges and vertices in common, and nothing else, if not whole triangles.
[[nodiscard]] std::vector<Surface> imprint(std::span<const Surface> surfaces, const Options& options = {});

}  // namespace strata
