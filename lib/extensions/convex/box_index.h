#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kernel/box.h"

namespace strata::convex {

/// Finds among many boxes those that overlap another one. A balanced tree: every node has half of the boxes on either
/// side, divided along the axis in which their centres reach farthest. Immutable, safe to ask from many threads.
class BoxIndex {
 public:
  BoxIndex() = default;
  /// O(n log n).
  explicit BoxIndex(std::vector<Box> boxes);

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

  /// Calls `visit(number)` for every box that overlaps `range` until it returns false; false if it did. The order is
  /// the same each time. O(log n + found) for small boxes that are apart.
  template <class Visit>
  bool for_each_overlapping(const Box& range, const Visit& visit) const {
    return boxes_.empty() || descend(0, 0, order_.size(), range, visit);
  }

 private:
  static constexpr std::size_t leaf = 8;  ///< boxes that are not divided any more

  void build(std::size_t node, std::size_t first, std::size_t last);
  template <class Visit>
  bool descend(std::size_t node, std::size_t first, std::size_t last, const Box& range, const Visit& visit) const {
    if (!nodes_[node].overlaps(range)) return true;
    if (last - first > leaf) {
      const std::size_t middle = first + (last - first) / 2;
      return descend(2 * node + 1, first, middle, range, visit) && descend(2 * node + 2, middle, last, range, visit);
    }
    for (std::size_t i = first; i < last; ++i)
      if (boxes_[order_[i]].overlaps(range) && !visit(order_[i])) return false;
    return true;
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;  ///< those of a node follow one another
  std::vector<Box> nodes_;            ///< the children of node k are 2 k + 1 and 2 k + 2
};

}  // namespace strata::convex
