#include "extensions/convex/box_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace strata::convex {
namespace {

/// Halves of coordinates: their sum does not overflow. Some number where a box has no end on either side.
double centre(const Box& box, std::size_t axis) {
  const double c = box.lower[axis] / 2 + box.upper[axis] / 2;
  return std::isnan(c) ? 0 : c;
}

}  // namespace

BoxIndex::BoxIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes_.empty()) build(0, 0, order_.size());
}

void BoxIndex::build(std::size_t node, std::size_t first, std::size_t last) {
  if (nodes_.size() <= node) nodes_.resize(node + 1);
  Box all, centres;
  for (std::size_t i = first; i < last; ++i) {
    const Box& box = boxes_[order_[i]];
    all.include(box);
    centres.include(std::array{centre(box, 0), centre(box, 1), centre(box, 2)});
  }
  nodes_[node] = all;
  if (last - first <= leaf) return;
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (centres.upper[i] - centres.lower[i] > centres.upper[axis] - centres.lower[axis]) axis = i;
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(centre(boxes_[a], axis), a) < std::pair(centre(boxes_[b], axis), b);
  });
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

}  // namespace strata::convex
