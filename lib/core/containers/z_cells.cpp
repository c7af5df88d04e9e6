#include "core/containers/z_cells.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/containers/z_order.h"

namespace strata {

ZCells::ZCells(const Box& bounds) : lower_(bounds.lower) {
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, bounds.upper[i] / 2 - bounds.lower[i] / 2);
  per_unit_ = 512 / extent;
}

std::uint32_t ZCells::code(const std::array<double, 3>& point) const {
  std::array<std::uint32_t, 3> at{};
  for (std::size_t i = 0; i < 3; ++i)
    at[i] = static_cast<std::uint32_t>(std::clamp((point[i] - lower_[i]) * per_unit_, 0.0, 1023.0));
  return z_order(at[0], at[1], at[2]);
}

void sort_by_code(FreshArray<PlacedItem>& placed) {
  constexpr std::uint32_t bits = 10, mask = (1u << bits) - 1;
  std::array<std::array<std::size_t, mask + 1>, 3> first{};
  for (const PlacedItem& p : placed)
    for (std::uint32_t k = 0; k < 3; ++k) ++first[k][p.code >> k * bits & mask];
  FreshArray<PlacedItem> other(placed.size());
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (first[k][0] == placed.size()) continue;
    std::size_t sum = 0;
    for (std::size_t& f : first[k]) sum += std::exchange(f, sum);
    for (const PlacedItem& p : placed) other[first[k][p.code >> k * bits & mask]++] = p;
    std::swap(placed, other);
  }
}

}  // namespace strata
