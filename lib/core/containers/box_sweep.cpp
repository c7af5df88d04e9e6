#include "core/containers/box_sweep.h"

#include <array>

namespace strata {
namespace {

/// Quarters of coordinates: their differences do not overflow.
std::size_t sweep_axis(std::span<const Box> boxes, std::span<const std::uint32_t> order) {
  Box all;
  for (const std::uint32_t b : order) all.include(boxes[b]);
  std::array<double, 3> share{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double extent = all.upper[i] / 4 - all.lower[i] / 4;
    for (const std::uint32_t b : order)
      share[i] += extent > 0 ? (boxes[b].upper[i] / 4 - boxes[b].lower[i] / 4) / extent : 1;
  }
  return static_cast<std::size_t>(std::min_element(share.begin(), share.end()) - share.begin());
}

}  // namespace

BoxSweep sweep_of(std::span<const Box> boxes) {
  BoxSweep sweep;
  for (std::uint32_t b = 0; b < boxes.size(); ++b)
    if (!boxes[b].empty()) sweep.order.push_back(b);
  const std::size_t axis = sweep.axis = sweep_axis(boxes, sweep.order);
  std::sort(sweep.order.begin(), sweep.order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = boxes[a].lower[axis], y = boxes[b].lower[axis];
    return x != y ? x < y : a < b;
  });
  return sweep;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(std::span<const Box> boxes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for_each_overlapping_pair(boxes, [&](std::uint32_t a, std::uint32_t b) { pairs.emplace_back(a, b); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace strata
