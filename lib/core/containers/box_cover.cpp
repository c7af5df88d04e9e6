#include "core/containers/box_cover.h"

#include <algorithm>
#include <utility>

namespace strata {

BoxCover::BoxCover(std::vector<Box> boxes) : boxes_(std::move(boxes)), rows_(width * width, 0) {
  for (const Box& b : boxes_) bounds_.include(b);
  for (std::size_t i = 0; i < 3; ++i) {
    const double extent = bounds_.upper[i] / 2 - bounds_.lower[i] / 2;
    const double cells = width / 2.0 / extent;
    per_cell_[i] = extent > 0 && cells < Box::infinity ? cells : 0;
  }
  for (const Box& b : boxes_) {
    const auto [lower, upper] = cells_of(b);
    const std::uint64_t bits = (~std::uint64_t{0} >> (width - 1 - (upper[0] - lower[0]))) << lower[0];
    for (std::uint32_t z = lower[2]; z <= upper[2]; ++z)
      for (std::uint32_t y = lower[1]; y <= upper[1]; ++y) rows_[z * width + y] |= bits;
  }
  tree_ =
      BoxTree::by_surface_area(static_cast<std::uint32_t>(boxes_.size()), [&](std::span<const std::uint32_t> items) {
        Box all;
        for (const std::uint32_t i : items) all.include(boxes_[i]);
        return all;
      });
}

/// Monotone in each coordinate, so boxes that meet have a cell in common.
BoxCover::Cells BoxCover::cells_of(const Box& box) const {
  const auto cell = [&](double x, std::size_t i) {
    const double at = (x - bounds_.lower[i]) * per_cell_[i];
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, width - 1.0)) : 0U;
  };
  Cells cells{};
  for (std::size_t i = 0; i < 3; ++i) {
    cells.lower[i] = cell(box.lower[i], i);
    cells.upper[i] = cell(box.upper[i], i);
  }
  return cells;
}

bool BoxCover::meets_marked_cell(const Box& box) const {
  const auto [lower, upper] = cells_of(box);
  const std::uint64_t bits = (~std::uint64_t{0} >> (width - 1 - (upper[0] - lower[0]))) << lower[0];
  for (std::uint32_t z = lower[2]; z <= upper[2]; ++z)
    for (std::uint32_t y = lower[1]; y <= upper[1]; ++y)
      if ((rows_[z * width + y] & bits) != 0) return true;
  return false;
}

bool BoxCover::meets(const Box& box) const {
  if (!box.overlaps(bounds_) || !meets_marked_cell(box)) return false;
  return !tree_.for_each_near(box, [&](std::uint32_t b) { return !boxes_[b].overlaps(box); });
}

}  // namespace strata
