#pragma once
#include <cmath>

#include "core/exact/bounded.h"

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
    const Pair s = sum(a.value, b.value), t = sum(a.low, b.low);
    const Pair v = quick_sum(s.high, s.low + t.high);
    const Pair r = quick_sum(v.high, v.low + t.low);
    return {r.high, r.low, a.error + b.error + std::abs(r.high) * rounding};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const Pair p = product(a.value, b.value);
    const Pair r = quick_sum(p.high, p.low + (a.value * b.low + a.low * b.value));
    const double carried = a.size() * b.error + b.size() * a.error + a.error * b.error;
    return {r.high, r.low, carried + std::abs(r.high) * rounding + Bounded::underflow};
  }
  /// Requires that b is certainly not zero; otherwise the error is infinite or NaN.
  /// Underflow in the remainder is divided by b as well: it counts as an error of a.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.value / b.value;
    const DoubleDouble rest = a.without_error() - b.without_error() * DoubleDouble(first);
    const Pair q = quick_sum(first, (rest.value + rest.low) / b.value);
    const double distance = std::abs(b.value) * (1 - 0x1p-50) - b.error * Bounded::slack;
    if (!(distance > 0)) return {q.high, q.low, HUGE_VAL};
    const double carried =
        (a.error + Bounded::underflow) / distance + std::abs(q.high) * (1 + 0x1p-50) * (b.error / distance);
    return {q.high, q.low, carried * Bounded::slack + std::abs(q.high) * rounding + Bounded::underflow};
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
  struct Pair {
    double high, low;
  };
  static Pair sum(double a, double b) {  // Knuth: exact
    const double s = a + b, bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
  }
  static Pair quick_sum(double a, double b) {  // Dekker: exact for |a| >= |b| or a = 0
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static Pair split(double a) {  // Veltkamp: 26 bits each
    const double c = 134217729.0 * a, high = c - (c - a);
    return {high, a - high};
  }
  static Pair product(double a, double b) {  // Dekker: exact unless it underflows
    const double p = a * b;
    const Pair x = split(a), y = split(b);
    return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }
  [[nodiscard]] double size() const { return std::abs(value) * (1 + 0x1p-50); }
  [[nodiscard]] DoubleDouble without_error() const { return {value, low, 0}; }
};

}  // namespace strata
