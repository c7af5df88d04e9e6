#pragma once
#include <cstdint>
#include <vector>

#include "core/cells/occupancy.h"

namespace strata {

/// The assignment of bricks to cells.
///
/// Adjacent bricks with faces of the same single operand form a region. No face of another operand is in it, so the
/// winding numbers about all others are constant in it. Empty bricks belong to no cell, because no winding number is
/// needed there; with `everywhere`, adjacent empty bricks form regions as well.
class Regions {
 public:
  /// One pass over the bricks; union-find joins runs of bricks along x.
  Regions(const BrickGrid& bricks, const Occupancy& occupancy, bool everywhere);

  /// Some brick of each region.
  [[nodiscard]] const std::vector<std::uint32_t>& regions() const { return regions_; }
  /// Bricks with faces that may meet, in order.
  [[nodiscard]] const std::vector<std::uint32_t>& mixed() const { return mixed_; }
  /// The cell of a brick: 0 for empty bricks (unless everywhere) and those outside, otherwise a region's number + 1, or
  /// the number among the mixed bricks with `mixed_flag`.
  [[nodiscard]] std::uint32_t place(std::uint32_t brick) const { return places_[brick]; }
  static constexpr std::uint32_t mixed_flag = 0x80000000u;

 private:
  struct Run {
    std::uint32_t first = 0, last = 0;  ///< bricks
    std::uint32_t parent = 0;
    Occupancy::Owner owner = 0;
  };
  void find_runs(const Occupancy& occupancy, bool everywhere, std::uint32_t first, std::uint32_t last);
  void join_rows(std::size_t row, std::size_t other, std::uint32_t distance);
  [[nodiscard]] std::uint32_t root(std::uint32_t run);

  std::vector<Run> runs_;
  std::vector<std::uint32_t> first_run_;  ///< per row
  std::vector<std::uint32_t> regions_, mixed_;
  std::vector<std::uint32_t> places_;
};

}  // namespace strata
