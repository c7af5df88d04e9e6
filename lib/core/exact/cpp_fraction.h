#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "core/exact/cpp_integer.h"

namespace strata::detail {

/// A fraction of CppIntegers in lowest terms with a positive denominator: back end of Rational.
/// Source: Henrici 1956 for sums and products by the divisors of the parts; Knuth, 4.5.1.
class CppFraction {
 public:
  CppFraction() : denominator_(1) {}
  explicit CppFraction(const CppInteger& x) : numerator_(x), denominator_(1) {}
  /// The denominator is not zero.
  CppFraction(const CppInteger& numerator, const CppInteger& denominator);
  /// x is finite.
  explicit CppFraction(double x);

  CppFraction& operator+=(const CppFraction& b) { return *this = sum(*this, b, false); }
  CppFraction& operator-=(const CppFraction& b) { return *this = sum(*this, b, true); }
  CppFraction& operator*=(const CppFraction& b) { return *this = *this * b; }
  CppFraction& operator/=(const CppFraction& b) { return *this = *this / b; }
  friend CppFraction operator+(const CppFraction& a, const CppFraction& b) { return sum(a, b, false); }
  friend CppFraction operator-(const CppFraction& a, const CppFraction& b) { return sum(a, b, true); }
  friend CppFraction operator*(const CppFraction& a, const CppFraction& b);
  friend CppFraction operator/(const CppFraction& a, const CppFraction& b);
  friend bool operator==(const CppFraction& a, const CppFraction& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }

  [[nodiscard]] int sign() const { return numerator_.sign(); }
  [[nodiscard]] int compare(const CppFraction& b) const;  ///< its sign is that of the difference
  [[nodiscard]] int compare(std::int64_t b) const;
  [[nodiscard]] std::string str() const;
  [[nodiscard]] const CppInteger& numerator() const { return numerator_; }
  [[nodiscard]] const CppInteger& denominator() const { return denominator_; }
  void negate() { numerator_.backend().negate(); }

 private:
  static CppFraction sum(const CppFraction& a, const CppFraction& b, bool is_difference);
  void make_denominator_positive();

  CppInteger numerator_, denominator_;
};

inline void negate(CppFraction& x) { x.negate(); }
[[nodiscard]] inline const CppInteger& numerator_of(const CppFraction& x) { return x.numerator(); }
[[nodiscard]] inline const CppInteger& denominator_of(const CppFraction& x) { return x.denominator(); }
[[nodiscard]] inline std::span<const std::uint64_t> numerator_magnitude(const CppFraction& x) {
  return magnitude(x.numerator());
}
[[nodiscard]] inline std::span<const std::uint64_t> denominator_magnitude(const CppFraction& x) {
  return magnitude(x.denominator());
}

}  // namespace strata::detail
