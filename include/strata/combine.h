#pragma once
/// Booleans from arrays to arrays: the function beneath Solid and Expression, for callers with meshes of their own.
///
/// All functions are pure; calls from many threads do not disturb each other.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "strata/attributes.h"
#include "strata/errors.h"
#include "strata/formula.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rounding.h"

namespace strata {

/// Where the time went and what was found, in the order of the stages. For reports: names may change.
struct Profile {
  std::vector<std::pair<std::string, double>> seconds;  ///< per stage
  std::vector<std::pair<std::string, std::uint64_t>>
      counts;  ///< pairs, points, pieces, ...; decisions per tier if counted
};

/// An operand whose vertices may be rationals, as in ExactMesh; `exact` is empty for ordinary meshes. It looks at
/// arrays that the caller owns. A mesh with rationals is never repaired: of class overlapping, repair and soup it may
/// cross itself, but must be closed.
struct Operand {
  MeshView mesh;
  std::span<const ExactVertex> exact;
  bool is_checked = false;  ///< known to bound a solid, as a Solid does: not checked again, if there are rationals
  const Attributes* attributes = nullptr;  ///< what the result is to carry on (carry_attributes.h); null: nothing
};

/// Facts about a boundary, whose vertices are rational.
struct MeasuredBoundary {
  std::uint64_t vertices = 0, triangles = 0;
  Measures measures;
};

/// The regularized boundary of the result.
struct BooleanResult {
  Mesh mesh;  ///< unsplit faces first in input order, then split ones; new vertices rounded to nearest
  std::vector<Source> sources;               ///< one per triangle
  std::vector<ExactVertex> exact;            ///< exact positions of rounded vertices, if Options::exact_vertices
  std::optional<MeasuredBoundary> measured;  ///< the exact result, if Options::measure
  std::optional<RoundingReport> rounding;    ///< what moved, if Options::rounding
  Attributes attributes;                     ///< if an operand has any, or Options::cut_material is given
  std::vector<Defect> notes;                 ///< what was resolved on the way in (seams welded, degenerate faces)
  Profile profile;
};

/// Regularized Boolean of n solids, exact on the coordinates given. The combinatorics are those of the exact result;
/// coordinates of new vertices are the nearest doubles.
///
/// Faces that do not meet another operand come out untouched: same vertices, same triangle, same order (but operands of
/// one union that have coincident facets are united first, and their faces stand together). Pieces of one face are
/// merged. Edges and vertices shared by several sheets are written once: the result may be non-manifold there.
///
/// Rounding: the combinatorics stay those of the exact result, but where features are some ulps apart, rounded
/// triangles may cross or lose their area. Options::rounding rearranges them there; `exact` has the exact positions,
/// and a Solid keeps them.
///
/// Degenerate cases: operands may touch, coincide and overlap anywhere. Where facets coincide with the interiors on the
/// same side, one of them is in a union and in an intersection; with the interiors on opposite sides, neither is in
/// either. Solids that only touch have an empty intersection. Empty operands are empty sets; of no operands the result
/// is empty. degenerate_contact.h specifies what every degenerate contact gives.
///
/// Sources: every triangle lies in one face of one operand. If operands have attributes and faces of several coincide,
/// it is that of the first operand that keeps it: the first whose faces there, without those of the others or after
/// them, change what is inside. That is the first operand that has a face there, for the four operations about solids.
/// Without attributes it is one of the operands that have a face there. If an operand has attributes, the result has
/// them as carry_attributes.h says. In an intersection cut faces are those of all operands but the first, else those
/// that are turned over.
///
/// Laws: those of sets, as point sets. Same bytes for any number of threads. With another engine the solid is the same,
/// but its triangles are not.
///
/// Expected O(n + m log m + k log k) for n faces, m of them near other operands, and k pairs that meet. Memory O(n +
/// k).
///
/// Throws InputError (an operand is not what was declared; `operand()` says which), std::invalid_argument (`exact` is
/// not in order, or the mesh does not hold the nearest doubles; attributes do not fit their mesh, or the engine carries
/// none), Cancelled, std::length_error (more than 2^32 - 2
/// vertices or faces in all). Source: per stage, lib/ARCHITECTURE.md.
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const MeshView> operands,
                                    const Options& options = {});
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const Operand> operands,
                                    const Options& options = {});

/// The points for which a closed formula holds, in one arrangement of all operands, however often each occurs;
/// regularized and else as above. Throws std::invalid_argument if the formula holds outside of all operands, so that
/// the result is not bounded, or if the number of operands is not the formula's.
[[nodiscard]] BooleanResult combine(const Formula& formula, std::span<const Operand> operands,
                                    const Options& options = {});

/// Another way to compute what `combine` computes, exact and by independent methods, as a check on it: give its address
/// as Options::engine. Extensions provide engines: `bsp_engine` (bsp.h), `layer_engine` (query.h). Laws: every engine
/// gives the same solid as a point set, and the same bytes for any number of threads.
struct Engine {
  const char* name;  ///< as on the command line
  BooleanResult (*combine)(Operation operation, std::span<const Operand> operands, const Options& options);
  /// The same for a bounded formula; null if the engine has only the four operations.
  BooleanResult (*evaluate)(const Formula& formula, std::span<const Operand> operands, const Options& options);
  /// Every triangle that it makes lies in the face that is its source, so that attributes can be carried.
  bool keeps_faces = false;
};

}  // namespace strata
