#pragma once
#include <cstdint>
#include <vector>

#include "extensions/scene/direction_index.h"
#include "extensions/scene/sight.h"
#include "strata/options.h"

namespace strata {

/// t dominates s: on the rays from the origin that meet both, s comes first.
struct Domination {
  std::uint32_t s = 0, t = 0;
  friend auto operator<=>(const Domination&, const Domination&) = default;
};

/// The relations between the faces of a scene as seen from the origin.
struct Dominance {
  std::vector<Domination> dominations;  ///< sorted
  std::vector<Domination> crossings;    ///< pairs of faces that cross; s < t, sorted
  std::uint64_t pairs_tested = 0;
};

/// Tests the faces that share a square of directions. `turns` are those of all faces; flat faces take no part. O(n log
/// n + pairs that share a square), in parallel; the same for any number of threads.
[[nodiscard]] Dominance find_dominance(const Sight& sight, const DirectionIndex& index,
                                       const std::vector<Sign>& orientations, const Monitor& monitor);

}  // namespace strata
