#pragma once
#include <cmath>

#include "core/exact/bounded.h"
#include "core/exact/two_product.h"
#include "core/exact/two_sum.h"

namespace strata {

/// An unevaluated sum value + low of two doubles (106 bits) with a bound on its distance from the exact value.
///
/// Sums, products and quotients are those of Joldes, Muller and Popescu 2017 (AccurateDWPlusDW, DWTimesDW1, DWDivDW2),
/// whose relative errors are at most 15 u^2 + 56 u^3 with u = 2^-53; 2^-100 is added for each, and 2^-1000 for
/// underflow, carried through as in Bounded. Overflow makes the bound infinite or NaN, and then nothing is certain.
struct DoubleDouble {
  double value = 0;  ///< the sum rounded to nearest
  double low = 0;
  double error = 0;

  static constexpr double rounding = 0x1p-100;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double exact) : value(exact) {}                 // NOLINT: an exact double is a sum
  constexpr DoubleDouble(Bounded x) : value(x.value), error(x.error) {}  // NOLINT
  constexpr DoubleDouble(double v, double l, double e) : value(v), low(l), error(e) {}

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const WithRest s = two_sum(a.value, b.value), t = two_sum(a.low, b.low);
    const WithRest v = quick_two_sum(s.value, s.rest + t.value);
    const WithRest r = quick_two_sum(v.value, v.rest + t.rest);
    return {r.value, r.rest, a.error + b.error + std::abs(r.value) * rounding};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const WithRest p = dekker_product(a.value, b.value);
    const WithRest r = quick_two_sum(p.value, p.rest + (a.value * b.low + a.low * b.value));
    const double carried = a.size() * b.error + b.size() * a.error + a.error * b.error;
    return {r.value, r.rest, carried + std::abs(r.value) * rounding + Bounded::underflow};
  }
  /// Requires that b is certainly not zero; otherwise the error is infinite or NaN.
  /// Underflow in the remainder is divided by b as well: it counts as an error of a.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.value / b.value;
    const DoubleDouble rest = a.without_error() - b.without_error() * DoubleDouble(first);
    const WithRest q = quick_two_sum(first, (rest.value + rest.low) / b.value);
    const double distance = std::abs(b.value) * (1 - 0x1p-50) - b.error * Bounded::slack;
    if (!(distance > 0)) return {q.value, q.rest, HUGE_VAL};
    const double carried =
        (a.error + Bounded::underflow) / distance + std::abs(q.value) * (1 + 0x1p-50) * (b.error / distance);
    return {q.value, q.rest, carried * Bounded::slack + std::abs(q.value) * rounding + Bounded::underflow};
  }
  DoubleDouble operator-() const { return {-value, -low, error}; }

  /// As a double with a bound, which leaves room for the rounding of `lower()` and `upper()` as every Bounded does.
  [[nodiscard]] Bounded bounded() const {
    if (low == 0 && error == 0) return value;
    return {value, (std::abs(low) + error) * Bounded::slack + std::abs(value) * Bounded::rounding};
  }

  /// True when every number within the bound rounds to `value`.
  [[nodiscard]] bool rounds_to_value() const {
    const double e = error * Bounded::slack + std::abs(low) * 0x1p-50;
    return value + (low + e) == value && value + (low - e) == value;
  }

 private:
  [[nodiscard]] double size() const { return std::abs(value) * (1 + 0x1p-50); }
  [[nodiscard]] DoubleDouble without_error() const { return {value, low, 0}; }
};

}  // namespace strata
