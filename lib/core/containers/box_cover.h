#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/box_tree.h"
#include "core/kernel/box.h"

namespace strata {

/// Asks of many boxes whether they meet any of some others. Most are answered by a grid of cells, one bit each, the
/// rest by a tree. An immutable value. O(m log m) to make for m boxes, none of which may be empty.
class BoxCover {
 public:
  explicit BoxCover(std::vector<Box> boxes);

  /// True when the box has a point in common with one of them. Thread-safe.
  [[nodiscard]] bool meets(const Box& box) const;

 private:
  static constexpr std::uint32_t width = 64;  ///< of the grid, in cells
  struct Cells {
    std::array<std::uint32_t, 3> lower, upper;
  };
  [[nodiscard]] Cells cells_of(const Box& box) const;
  [[nodiscard]] bool meets_marked_cell(const Box& box) const;

  std::vector<Box> boxes_;
  Box bounds_;
  std::array<double, 3> per_cell_{};  ///< cells per length
  std::vector<std::uint64_t> rows_;   ///< a bit per cell
  BoxTree tree_;
};

}  // namespace strata
