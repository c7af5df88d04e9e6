#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "core/kernel/input_complex.h"

namespace strata {

/// A box of integer grid coordinates, closed on both sides; as the box of a cell, half-open.
struct GridBox {
  std::array<std::int32_t, 3> lower;
  std::array<std::int32_t, 3> upper;

  /// The closed box between two points.
  static GridBox between(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    return {{std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])},
            {std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2])}};
  }
  /// Of a half-open box.
  [[nodiscard]] bool holds(const std::array<std::int32_t, 3>& g) const {
    return lower[0] <= g[0] && g[0] < upper[0] && lower[1] <= g[1] && g[1] < upper[1] && lower[2] <= g[2] &&
           g[2] < upper[2];
  }
  [[nodiscard]] bool overlaps(const GridBox& b) const {
    return lower[0] <= b.upper[0] && b.lower[0] <= upper[0] && lower[1] <= b.upper[1] && b.lower[1] <= upper[1] &&
           lower[2] <= b.upper[2] && b.lower[2] <= upper[2];
  }
  /// Of a closed box and the half-open box of a cell.
  [[nodiscard]] bool reaches_into(const GridBox& cell) const {
    return lower[0] < cell.upper[0] && cell.lower[0] <= upper[0] && lower[1] < cell.upper[1] &&
           cell.lower[1] <= upper[1] && lower[2] < cell.upper[2] && cell.lower[2] <= upper[2];
  }
};

/// A monotone map of doubles to integers, one per axis: x <= y implies at(x) <= at(y), because scaling, subtraction,
/// clamping and truncation each round monotonically. So ordered points remain ordered or become equal, and boxes that
/// overlap in space overlap on the grid. Nothing else is concluded from grid coordinates.
class Grid {
 public:
  static constexpr std::int32_t extent = 1 << 30;

  Grid() = default;
  /// A grid that resolves the box [lower, upper] into `extent` steps along its longest side.
  Grid(const InputComplex::Coordinates& lower, const InputComplex::Coordinates& upper);

  [[nodiscard]] std::int32_t at(int axis, double x) const {
    const double g = x * scale1_ * scale2_ - offset_[static_cast<std::size_t>(axis)];
    return static_cast<std::int32_t>(std::min(std::max(g, 0.0), static_cast<double>(extent)));
  }
  [[nodiscard]] std::array<std::int32_t, 3> at(const InputComplex::Coordinates& p) const {
    return {at(0, p[0]), at(1, p[1]), at(2, p[2])};
  }
  /// A double in [low, high] whose grid coordinate is as near to g as doubles permit.
  [[nodiscard]] double inverse(int axis, std::int32_t g) const;

  /// Grid box of a triangle.
  [[nodiscard]] GridBox box(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                            const InputComplex::Coordinates& c) const {
    GridBox r;
    for (std::size_t i = 0; i < 3; ++i) {
      r.lower[i] = at(static_cast<int>(i), std::min({a[i], b[i], c[i]}));
      r.upper[i] = at(static_cast<int>(i), std::max({a[i], b[i], c[i]}));
    }
    return r;
  }

 private:
  double scale1_ = 1, scale2_ = 1;
  std::array<double, 3> offset_{};
};

}  // namespace strata
