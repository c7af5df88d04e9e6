#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/box.h"

namespace strata {

/// Boxes in the order of a sweep.
struct BoxSweep {
  std::size_t axis = 0;              ///< along which boxes are shortest on average, beside what they span in all
  std::vector<std::uint32_t> order;  ///< of those that are not empty, by their lower ends, then by number
};

/// O(n log n).
[[nodiscard]] BoxSweep sweep_of(std::span<const Box> boxes);

/// Calls `visit(a, b)`, a < b, once for every pair of boxes that have a point in common; empty boxes have none. In an
/// order that depends on the boxes alone. O(n log n + pairs that overlap along the axis of the sweep).
template <class Visit>
void for_each_overlapping_pair(std::span<const Box> boxes, const Visit& visit) {
  const auto [axis, order] = sweep_of(boxes);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t a = order[i];
    for (std::size_t k = i + 1; k < order.size() && boxes[order[k]].lower[axis] <= boxes[a].upper[axis]; ++k)
      if (const std::uint32_t b = order[k]; boxes[a].overlaps(boxes[b])) visit(std::min(a, b), std::max(a, b));
  }
}

/// These pairs, by increasing numbers.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace strata
