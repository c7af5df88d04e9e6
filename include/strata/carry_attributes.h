#pragma once
/// Attributes of a result from those of its operands.
///
///   Solid part = Solid(body).with_attributes(paint) - drill;     // operations on solids carry attributes themselves
///   const Solid whole = resolve(mesh);                           // for others there is this:
///   const Solid painted = whole.with_attributes(
///       carry_attributes(std::array{AttributedMesh{mesh, &paint}}, whole.exact_mesh(), whole.sources()));
///
/// What is carried by itself: Booleans by `combine` and of solids, expressions, maps, splits by planes and by surfaces,
/// components, separation, incremental solids, `clip`, `imprint`, `cells_of`, `convex::pieces_of`. What tells its
/// sources, so that `carry_attributes` carries it: `resolve`, solids and surfaces made from meshes, `arrange`, and (by
/// a function of its own) `round_to_solid`. What does neither: hulls, Minkowski sums, sections, partitions.
///
/// Every triangle of a result lies in one face of an operand, its source; no triangle spans several. A value at a
/// corner of the result is that of its source face at this place:
///
/// - at a corner of the face, the value there, bit by bit;
/// - elsewhere by the rule of the channel, from the exact place in the face and the values as they are, rounded once to
///   the type of the channel: to nearest, ties to even. So where faces have equal values along a common edge, they have
///   equal ones at every point of it: seams stay where they are, and none comes up.
///
/// Numbers: an infinity or NaN reaches the new corners of a face, but not those on the side opposite to its own.
/// Directions (`spherical`) that cancel out become those of the nearest corner; those of a face that comes out turned
/// over, as of what a difference takes away, are negated. A place off the source face, as that of a filled hole, has
/// the values of the nearest point of the face, in doubles.
///
/// Where faces of several operands coincide, the first operand that keeps the face speaks (`combine`), the same for any
/// number of threads. Faces that a cut makes belong to the operand that cut.
#include <span>
#include <string>
#include <vector>

#include "strata/attributes.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rounding.h"
#include "strata/transform.h"

namespace strata {

/// A mesh that someone else owns, and what it carries. Null: nothing.
struct AttributedMesh {
  ExactMeshView mesh;
  const Attributes* attributes = nullptr;
};

/// Which faces of a result are cut surfaces, which Options::cut_material is for.
enum class CutFaces {
  turned,            ///< that are turned over: what differences take away
  of_later_operands  ///< of all operands but the first: what an intersection cuts away
};

/// What a result carries: channels on corners and faces, and on vertices where all operands have it there and all
/// corners at every vertex agree. A channel on vertices that do not becomes one on corners.
///
/// Operands need not have the same channels. The result has those of all, in the order in which they come up:
///
/// - An operand without a channel has 0 in it; -1 if the numbers are integers of 32 bits (no material); white and
///   opaque in "color"; the normal of the face in three-dimensional directions.
/// - Channels of one name have the finest of their elements (face, vertex, corner), the most components (others get 0,
///   opacity in "color" 1), and the smallest type that holds all values of both: float and bytes give float, integers
///   and floats double. Bytes of "color" beside floats are divided by 255. `nearest` if either is, else as the first.
/// - Lists of materials, images, objects and groups are put one after the other; equal entries are one. Indices into
///   them follow. Numbers of a list that an operand does not have become entries with the number as their name, where
///   another operand has the list; where none has, they stay.
///
/// With Options::cut_material, cut faces without a material of their own (-1) have that one.
///
/// Requires what `combine` and the functions above give: sources of all triangles, which lie in their faces. Of the
/// options `threads`, `cancel` and `cut_material` count. The result does not depend on the number of threads. O(faces +
/// corners that are new), with rational arithmetic where double-doubles do not decide how to round. Throws
/// std::invalid_argument where attributes do not fit their mesh (see `check_attributes`), for sources of no face, and
/// where `cut_material` is given and "material" is no integer on faces; Cancelled. Source:
/// lib/core/attributes/theory.md.
[[nodiscard]] Attributes carry_attributes(std::span<const AttributedMesh> operands, ExactMeshView result,
                                          std::span<const Source> sources, const Options& options = {},
                                          CutFaces cut_faces = CutFaces::turned);

/// The same for a mesh that `round_to_solid` made of `exact`, with the same grid. Corners that were only moved keep
/// their values; others have the value at the nearest point of the face that they are part of, as rounded.
[[nodiscard]] Attributes carry_attributes(const AttributedMesh& exact, const RoundedMesh& rounded,
                                          const CoordinateGrid& grid, const Options& options = {});

/// Throws std::invalid_argument where attributes do not fit a mesh of so many vertices and faces, with the name of the
/// channel: names that are empty or come twice; 0 or more than 4 components; another number of values than elements
/// times components; integers of 32 bits that are not `nearest`, bytes that are `spherical`; indices beyond a list that
/// is not empty; materials with images that there are not. O(faces).
void check_attributes(const Attributes& attributes, std::size_t vertices, std::size_t faces);

/// Attributes of a mesh under an affine map, as `transform` maps the mesh: directions of three components, which are
/// normals, are multiplied by the inverse transpose of the map and have length 1 again, correctly rounded; corners of
/// triangles that the map turns round are exchanged. Everything else stays. O(size).
[[nodiscard]] Attributes transform(const Attributes& attributes, const Transform& map);

/// Attributes of a part of a mesh: of these faces and these vertices of it, in this order. Requires that they exist.
[[nodiscard]] Attributes part_of(const Attributes& attributes, std::span<const std::uint32_t> faces,
                                 std::span<const std::uint32_t> vertices);

/// The channels with these names, in their order, and the lists that they refer to (images go with materials).
[[nodiscard]] Attributes only(const Attributes& attributes, std::span<const std::string> names);

}  // namespace strata
