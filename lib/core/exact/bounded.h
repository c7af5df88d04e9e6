#pragma once
#include <cmath>
#include <optional>

#include "core/exact/sign.h"

namespace strata {

/// A double with a bound on its distance from the exact value that it represents (running error analysis).
///
/// Every operation adds to the bound: the propagated errors of the operands, |result| * 2^-52 for its own rounding
/// (twice the unit roundoff), and 2^-1000 for underflow (which loses at most 2^-1074 in each partial result). The
/// bounds are themselves computed in doubles. Each step loses at most a relative 2^-50 of them, so an expression of at
/// most 2^19 steps loses less than 2^-30, which `sign()`, `lower()` and `upper()` compensate. Overflow makes the bound
/// infinite or NaN, and then nothing is certain. See theory.md, "Running errors".
struct Bounded {
  double value = 0;
  double error = 0;

  static constexpr double rounding = 0x1p-52;
  static constexpr double underflow = 0x1p-1000;
  static constexpr double slack = 1 + 0x1p-30;

  constexpr Bounded() = default;
  constexpr Bounded(double exact) : value(exact) {}  // NOLINT: an exact double is a bounded one
  constexpr Bounded(double v, double e) : value(v), error(e) {}

  friend Bounded operator+(Bounded a, Bounded b) {
    const double v = a.value + b.value;
    return {v, a.error + b.error + std::abs(v) * rounding};
  }
  friend Bounded operator-(Bounded a, Bounded b) {
    const double v = a.value - b.value;
    return {v, a.error + b.error + std::abs(v) * rounding};
  }
  friend Bounded operator*(Bounded a, Bounded b) {
    const double v = a.value * b.value;
    const double carried = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    return {v, carried + std::abs(v) * rounding + underflow};
  }
  /// Requires that b is certainly not zero; otherwise the error is infinite or NaN.
  /// The divisor's relative error comes first: |q| * b.error may underflow where its quotient by b does not.
  friend Bounded operator/(Bounded a, Bounded b) {
    const double q = a.value / b.value;
    const double distance = std::abs(b.value) - b.error * slack;
    if (!(distance > 0)) return {q, HUGE_VAL};
    const double carried = a.error / distance + std::abs(q) * (b.error / distance);
    return {q, carried * slack + std::abs(q) * rounding + underflow};
  }
  Bounded operator-() const { return {-value, error}; }

  /// The sign of the exact value, if the bound decides it. An exact zero is certain.
  [[nodiscard]] std::optional<Sign> sign() const {
    const double e = error * slack;
    if (value > e) return Sign::positive;
    if (-value > e) return Sign::negative;
    if (value == 0 && error == 0) return Sign::zero;
    return std::nullopt;
  }
  [[nodiscard]] double lower() const { return value - error * slack; }
  [[nodiscard]] double upper() const { return value + error * slack; }
};

}  // namespace strata
