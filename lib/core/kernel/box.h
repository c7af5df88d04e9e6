#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace strata {

/// An axis-parallel box of points, closed. The default box is empty: lower > upper.
struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};

  [[nodiscard]] bool empty() const { return lower[0] > upper[0]; }
  /// Requires coordinates that are numbers.
  void include(const std::array<double, 3>& p) {  // without a loop, boxes stay in registers
    lower = {std::min(lower[0], p[0]), std::min(lower[1], p[1]), std::min(lower[2], p[2])};
    upper = {std::max(upper[0], p[0]), std::max(upper[1], p[1]), std::max(upper[2], p[2])};
  }
  void include(const Box& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], b.lower[i]);
      upper[i] = std::max(upper[i], b.upper[i]);
    }
  }
  [[nodiscard]] bool overlaps(const Box& b) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (lower[i] > b.upper[i] || b.lower[i] > upper[i]) return false;
    return true;
  }
};

}  // namespace strata
