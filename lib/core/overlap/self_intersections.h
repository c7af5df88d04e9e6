#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/containers/packed_boxes.h"
#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/fans.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Two faces of one mesh that share a point other than vertices and edges that both have.
struct SelfIntersection {
  std::uint32_t face = 0, other = 0;  ///< face < other
  bool is_coplanar = false;           ///< they overlap in one plane
  Vertex at{};                        ///< the doubles near one of their common points
};

/// Where faces of a mesh intersect: all pairs, how they do, and vertices around which there are none.
struct SelfCrossings {
  EmbeddedStars stars;
  std::vector<SelfIntersection> pairs;
  std::vector<PairIntersections> met;  ///< in parts, each with all of some pairs
};

/// One mesh that may cross itself, as input. Refers to the mesh.
[[nodiscard]] InputComplex complex_of(ExactMeshView mesh);
[[nodiscard]] inline InputComplex complex_of(MeshView mesh) { return complex_of(ExactMeshView(mesh, {})); }

/// The search for pairs of faces of the first operand that intersect, by their numbers. Vertices are equal where their
/// numbers are: `identify` has no effect here. It may be asked for a first pair, and then for all.
class SelfIntersectionSearch {
 public:
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  /// Requires finite coordinates, valid indices and faces of positive area. `stars`: of this mesh, if it is closed,
  /// else null; the result is the same, and found sooner. The input must outlive the search. O(n log n), in parallel.
  SelfIntersectionSearch(const InputComplex& input, const EmbeddedStars* stars);
  SelfIntersectionSearch(const SelfIntersectionSearch&) = delete;
  SelfIntersectionSearch& operator=(const SelfIntersectionSearch&) = delete;

  /// Exact: a pair is found if and only if it is one. By increasing numbers. Ends when at least `enough` pairs are
  /// found, the same ones for any number of threads; what was seen to have none before is not searched again.
  /// `met`: becomes the intersections of all pairs, if these are fewer. O(n + pairs whose boxes overlap), in parallel.
  /// Throws Cancelled.
  [[nodiscard]] std::vector<SelfIntersection> find(const Monitor& monitor, std::size_t enough = all,
                                                   std::vector<PairIntersections>* met = nullptr);

 private:
  /// Pairs of faces that may intersect; parts are the groups of boxes, then the parts of fans.
  void append_pairs_of(std::size_t part, std::vector<PackedBoxes::Pair>& pairs) const;

  const InputComplex& input_;
  Fans fans_;
  PackedBoxes boxes_;
  std::vector<char> finds_none_;  ///< per task: it was done and found no pair
};

/// The same, asked once.
[[nodiscard]] std::vector<SelfIntersection> find_self_intersections(const InputComplex& input,
                                                                    const EmbeddedStars* stars, const Monitor& monitor,
                                                                    std::size_t enough = SelfIntersectionSearch::all,
                                                                    std::vector<PairIntersections>* met = nullptr);

}  // namespace strata
