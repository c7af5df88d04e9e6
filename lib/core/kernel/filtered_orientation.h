#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "core/exact/sign.h"
#include "core/exact/two_product.h"

namespace strata {

/// A point of a plane, in doubles.
using PlanePoint = std::array<double, 2>;

/// Orientation of three points: 1 counter-clockwise, -1 clockwise, 0 when doubles do not decide. Shewchuk's bound (3 +
/// 16 u) u, and 2^-1000 for underflow; core/kernel/theory.md, "Filters".
[[nodiscard]] inline int filtered_orientation(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  const double left = (q[0] - p[0]) * (r[1] - p[1]), right = (q[1] - p[1]) * (r[0] - p[0]), value = left - right;
  constexpr double factor = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double bound = factor * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return static_cast<int>(value > bound) - static_cast<int>(-value > bound);
}

/// True when the difference a - b is a double and `difference` is it. Source: Knuth; no overflow passes.
[[nodiscard]] inline bool is_exact_difference(double a, double b, double difference) {
  const double b_used = a - difference, a_used = difference + b_used;
  return (b_used - b) + (a - a_used) == 0;
}

/// Sign of ab - cd. Rounding is monotone, so different rounded products decide; equal ones differ in their rounding
/// errors. nullopt where an error may underflow or the products overflow.
[[nodiscard]] inline std::optional<Sign> compare_products(double a, double b, double c, double d) {
  const double left = a * b, right = c * d;
  if (left > right) return Sign::positive;
  if (left < right) return Sign::negative;
  if ((a == 0 || b == 0) && (c == 0 || d == 0)) return Sign::zero;
  if (!(std::abs(left) > 0x1p-900 && std::isfinite(left))) return std::nullopt;
  const double left_rest = product_error(a, b, left), right_rest = product_error(c, d, right);
  return left_rest == right_rest ? Sign::zero : left_rest > right_rest ? Sign::positive : Sign::negative;
}

/// Orientation of three points, exact: nullopt when a difference of coordinates is no double.
[[nodiscard]] inline std::optional<Sign> orientation_by_differences(const PlanePoint& p, const PlanePoint& q,
                                                                    const PlanePoint& r) {
  std::array<double, 2> u, v;
  for (std::size_t i = 0; i < 2; ++i) {
    u[i] = q[i] - p[i];
    v[i] = r[i] - p[i];
    if (!is_exact_difference(q[i], p[i], u[i]) || !is_exact_difference(r[i], p[i], v[i])) return std::nullopt;
  }
  return compare_products(u[0], v[1], u[1], v[0]);
}

}  // namespace strata
