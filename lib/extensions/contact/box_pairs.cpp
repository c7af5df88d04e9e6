#include "extensions/contact/box_pairs.h"

#include <algorithm>
#include <array>

namespace strata::contact {
namespace {

/// The axis along which boxes are shortest on average, beside what they span in all.
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

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_boxes(std::span<const Box> boxes) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t b = 0; b < boxes.size(); ++b)
    if (!boxes[b].empty()) order.push_back(b);
  if (order.empty()) return {};
  const std::size_t axis = sweep_axis(boxes, order);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = boxes[a].lower[axis], y = boxes[b].lower[axis];
    return x != y ? x < y : a < b;
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && boxes[order[k]].lower[axis] <= boxes[order[i]].upper[axis]; ++k)
      if (boxes[order[i]].overlaps(boxes[order[k]])) pairs.push_back(std::minmax(order[i], order[k]));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace strata::contact
