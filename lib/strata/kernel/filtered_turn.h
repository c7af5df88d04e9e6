#pragma once
#include <array>
#include <cmath>

namespace strata {

/// A point of a plane, in doubles.
using PlanePoint = std::array<double, 2>;

/// Turn of three points: 1 counter-clockwise, -1 clockwise, 0 when doubles do not tell. Shewchuk's bound (3 + 16 u) u,
/// and 2^-1000 for underflow; kernel/theory.md, "Filters".
[[nodiscard]] inline int filtered_turn(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  const double left = (q[0] - p[0]) * (r[1] - p[1]), right = (q[1] - p[1]) * (r[0] - p[0]), value = left - right;
  constexpr double factor = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double bound = factor * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return static_cast<int>(value > bound) - static_cast<int>(-value > bound);
}

}  // namespace strata
