#pragma once
/// Booleans from arrays to arrays.
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "strata/errors.h"
#include "strata/formula.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// Where the time went and what was met, in the order of the stages.
struct Profile {
  std::vector<std::pair<std::string, double>> seconds;  ///< per stage
  std::vector<std::pair<std::string, std::uint64_t>>
      counts;  ///< pairs, points, pieces, ...; decisions per tier if counted
};

/// An operand whose vertices may be rationals; `exact` is empty for ordinary meshes. Rationals are taken as they are,
/// of whatever class: they may cross themselves where the class is overlapping or repair, but nothing is repaired.
struct Operand {
  MeshView mesh;
  std::span<const ExactVertex> exact;
  bool is_checked = false;  ///< of a Solid: if there are rationals, that they bound one is not asked again
};

/// The regularized boundary of the result.
struct BooleanResult {
  Mesh mesh;  ///< unsplit faces first in input order, then split ones; new vertices rounded to nearest
  std::vector<Source> sources;     ///< one per triangle
  std::vector<ExactVertex> exact;  ///< exact places of rounded vertices, if Options::exact_vertices
  std::vector<Defect> notes;       ///< what was resolved on the way in (seams welded, degenerate faces)
  Profile profile;
};

/// Regularized Boolean of n solids, exact on the coordinates given.
/// The combinatorics are those of the exact result; coordinates of new vertices are the nearest doubles.
/// Faces that do not meet another operand come out untouched: same vertices, same triangle, same order (but operands of
/// one union that have walls in common are united first, and their faces stand together).
/// Edges and vertices shared by several sheets are written once (non-manifold). degenerate_contact.h specifies what
/// every degenerate contact gives.
/// Laws: commutative in the operands (as point sets); same bytes for any number of threads.
/// With another engine the solid is the same, but its triangles are not.
/// Throws InputError (an operand is not what was declared), std::invalid_argument (exact places that are not in order
/// or do not belong to the doubles), Cancelled, std::length_error (more than 2^32 - 2 vertices or faces in all).
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const MeshView> operands,
                                    const Options& options = {});
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const Operand> operands,
                                    const Options& options = {});

/// The points for which a closed formula holds, in one arrangement of all operands, however often each occurs. Throws
/// std::invalid_argument if these are not bounded or the number of operands is not the formula's; the rest as above.
[[nodiscard]] BooleanResult combine(const Formula& formula, std::span<const Operand> operands,
                                    const Options& options = {});

/// Another way to compute what `combine` computes, exact and with mathematics of its own. Extensions provide engines:
/// `bsp_engine` (bsp.h), `layer_engine` (query.h). Every engine gives the same solid as a point set, and the same bytes
/// for any number of threads.
struct Engine {
  const char* name;  ///< as on the command line
  BooleanResult (*combine)(Operation operation, std::span<const Operand> operands, const Options& options);
  /// The same for a bounded formula; null if the engine has only the four operations.
  BooleanResult (*evaluate)(const Formula& formula, std::span<const Operand> operands, const Options& options);
};

}  // namespace strata
