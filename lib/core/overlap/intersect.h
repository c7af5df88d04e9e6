#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/overlap/candidates.h"
#include "core/overlap/constraint.h"
#include "core/overlap/point_table.h"
#include "core/overlap/self_intersections.h"
#include "strata/options.h"

namespace strata {

/// All intersections of faces, as constraints of each face.
struct Intersections {
  std::vector<Constraint> constraints;  ///< by face, then by other face
  std::vector<EqualVertices> equal;     ///< input vertices found at one position, in order, each pair once
  PointTable points;                    ///< the input vertices and all points constructed
  /// Faces of which nothing is kept, in order, if these were sought. What two of them have in common is left out.
  std::optional<std::vector<std::uint32_t>> hidden;
  std::uint64_t pairs_tested = 0;   ///< pairs whose boxes overlap
  std::uint64_t pairs_meeting = 0;  ///< pairs that share a point, without those left out
};

/// Intersects every pair of faces that may meet: faces of different operands, or all faces if the input may intersect
/// itself. Each pair is tested in one cell, which owns it (core/cells/theory.md, "Ownership of a pair"). The same
/// result for any number of threads. The candidates must outlive it. Throws Cancelled.
[[nodiscard]] Intersections intersect(const Candidates& candidates, const Monitor& monitor);

/// The same in two steps, between which hidden faces can be sought. The first intersects all pairs but those of
/// coplanar faces, which it lists. Throws Cancelled.
[[nodiscard]] std::vector<PairIntersections> meet_faces_in_general(const Candidates& candidates,
                                                                   const Monitor& monitor);
/// The second intersects the pairs of coplanar faces of which one at least is not among `hidden`, which is in order.
/// The input must outlive the result. Throws Cancelled.
[[nodiscard]] Intersections intersect(const InputComplex& input, std::vector<PairIntersections> met,
                                      std::vector<std::uint32_t> hidden, const Monitor& monitor);

/// What a search of self-intersections met, in parts, as the same. The input must outlive it. Throws Cancelled.
[[nodiscard]] Intersections intersect(const InputComplex& input, const std::vector<PairIntersections>& met,
                                      const Monitor& monitor);

/// Intersects the given pairs of faces of one operand, each once; all others share nothing but vertices and edges of
/// both. The same result for any number of threads. The input must outlive it. Throws Cancelled.
[[nodiscard]] Intersections intersect(const InputComplex& input, std::span<const SelfIntersection> pairs,
                                      const Monitor& monitor);

}  // namespace strata
