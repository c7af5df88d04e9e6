#pragma once
#include <array>
#include <cstdint>

#include "core/containers/fresh_array.h"
#include "core/kernel/box.h"

namespace strata {

/// A cube divided into 1024 cells each way, along a Z-curve.
class ZCells {
 public:
  explicit ZCells(const Box& bounds);

  /// False where all cells would be one, or where the number of cells per unit is beyond all doubles.
  [[nodiscard]] bool are_useful() const { return per_unit_ < Box::infinity; }
  /// The place of a point's cell on the curve, below 2^30. Points outside count as those of the cube next to them.
  /// Requires that the cells are useful.
  [[nodiscard]] std::uint32_t code(const std::array<double, 3>& point) const;

 private:
  std::array<double, 3> lower_;
  double per_unit_;
};

/// An item and its place on a Z-curve, or another number to sort by.
struct PlacedItem {
  std::uint32_t code, item;
};

/// Sorts by code, 10 bits at a time from the lowest; equal codes keep their order. Requires codes below 2^30. O(n).
void sort_by_code(FreshArray<PlacedItem>& placed);

}  // namespace strata
