#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "strata/csg/options.h"
#include "strata/mesh/defect.h"
#include "strata/mesh/exact_mesh.h"
#include "strata/mesh/mesh.h"
#include "strata/mesh/source.h"

namespace strata {

/// Where the time went and what was met, in the order of the stages.
struct Profile {
  std::vector<std::pair<std::string, double>> seconds;  ///< per stage
  std::vector<std::pair<std::string, std::uint64_t>>
      counts;  ///< pairs, points, pieces, ...; decisions per tier if counted
};

/// An operand whose vertices may be rationals; `exact` is empty for ordinary meshes.
struct Operand {
  MeshView mesh;
  std::span<const ExactVertex> exact;
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
/// Faces that do not meet another operand come out untouched: same vertices, same triangle, same order.
/// Edges and vertices shared by several sheets are written once (non-manifold).
/// Laws: commutative in the operands (as point sets); same bytes for any number of threads.
/// Throws InputError (an operand is not what was declared), Cancelled, std::length_error (more than 2^32 - 2
/// vertices or faces in all).
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const MeshView> operands,
                                    const Options& options = {});
[[nodiscard]] BooleanResult combine(Operation operation, std::span<const Operand> operands,
                                    const Options& options = {});

}  // namespace strata
