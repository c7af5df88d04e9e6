#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/exact/sign.h"
#include "core/exact/two_product.h"
#include "core/exact/two_sum.h"

namespace strata {

/// Arithmetic on doubles that detects rounding. Coordinates on a common grid, or near each other, have differences and
/// products of few bits. If no step of a formula rounds, its result is exact, and its sign is right, zero included.
/// core/kernel/theory.md, "Exact steps".
class ExactSteps {
 public:
  using Vector = std::array<double, 3>;

  /// True when no step so far rounded, underflowed or overflowed.
  [[nodiscard]] bool are_exact() const { return exact_; }

  [[nodiscard]] double sum(double a, double b) {
    const WithRest s = two_sum(a, b);
    exact_ &= s.rest == 0;
    return s.value;
  }
  [[nodiscard]] double difference(double a, double b) { return sum(a, -b); }
  [[nodiscard]] double product(double a, double b) {
    const WithRest p = product_with_rest(a, b);
    exact_ &= p.rest == 0;
    return p.value;
  }

  [[nodiscard]] Vector difference(const Vector& p, const Vector& q) {
    return {difference(p[0], q[0]), difference(p[1], q[1]), difference(p[2], q[2])};
  }
  [[nodiscard]] Vector cross(const Vector& u, const Vector& v) {
    return {difference(product(u[1], v[2]), product(u[2], v[1])), difference(product(u[2], v[0]), product(u[0], v[2])),
            difference(product(u[0], v[1]), product(u[1], v[0]))};
  }
  /// Sign of u . v. Products may round here: their errors are doubles, too, and are added at the end. The last sum may
  /// round; rounding keeps its sign.
  [[nodiscard]] Sign sign_of_dot(const Vector& u, const Vector& v) {
    const WithRest x = product_with_rest(u[0], v[0]), y = product_with_rest(u[1], v[1]),
                   z = product_with_rest(u[2], v[2]);
    const WithRest xy = two_sum(x.value, y.value), all = two_sum(xy.value, z.value);
    const double rests = sum(sum(sum(x.rest, y.rest), z.rest), sum(xy.rest, all.rest));
    return sign_of(all.value + rests);
  }

 private:
  /// The error is a double unless the product is so small that the error may underflow. Overflow makes it infinite or
  /// NaN.
  [[nodiscard]] WithRest product_with_rest(double a, double b) {
    const double p = a * b;
    exact_ &= (std::abs(p) > 0x1p-900) | (a == 0) | (b == 0);
    return {p, product_error(a, b, p)};
  }

  bool exact_ = true;
};

/// Sign of ((b - a) x (c - a)) . (d - a), as orient3d, zero included; nullopt where a step rounds. Four points on a
/// common grid of 2^26 steps are decided, unless products are below 2^-900 or overflow.
[[nodiscard]] inline std::optional<Sign> orient3d_in_exact_steps(const ExactSteps::Vector& a,
                                                                 const ExactSteps::Vector& b,
                                                                 const ExactSteps::Vector& c,
                                                                 const ExactSteps::Vector& d) {
  ExactSteps steps;
  const auto u = steps.difference(b, a), v = steps.difference(c, a), w = steps.difference(d, a);
  if (!steps.are_exact()) return std::nullopt;
  const auto normal = steps.cross(u, v);
  if (!steps.are_exact()) return std::nullopt;
  const Sign sign = steps.sign_of_dot(normal, w);
  return steps.are_exact() ? std::optional(sign) : std::nullopt;
}

}  // namespace strata
