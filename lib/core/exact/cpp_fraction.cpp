#include "core/exact/cpp_fraction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace strata::detail {
namespace {

bool is_one(const CppInteger& x) { return x.backend().size() == 1 && *x.backend().limbs() == 1 && !x.backend().sign(); }

/// The product of x and y, the factors of which that are one cost nothing.
CppInteger product(const CppInteger& x, const CppInteger& y) {
  if (is_one(x)) return y;
  if (is_one(y)) return x;
  return x * y;
}

CppInteger without_factor(const CppInteger& x, const CppInteger& divisor) {
  return is_one(divisor) ? x : exact_quotient(x, divisor);
}

CppInteger divisor_of(const CppInteger& x, const CppInteger& y) {
  return is_one(x) || is_one(y) ? CppInteger(1) : common_divisor(x, y);
}

/// Takes common factors of 2 from n and the power d of 2.
void reduce_by_twos(CppInteger& n, CppInteger& d) {
  const std::size_t of_d = trailing_zeros(d), common = n.sign() == 0 ? of_d : std::min(trailing_zeros(n), of_d);
  shift_down(n, common);
  shift_down(d, common);
}

}  // namespace

CppFraction::CppFraction(const CppInteger& numerator, const CppInteger& denominator) {
  const CppInteger divisor = divisor_of(numerator, denominator);
  numerator_ = without_factor(numerator, divisor);
  denominator_ = without_factor(denominator, divisor);
  make_denominator_positive();
}

CppFraction::CppFraction(double x) : denominator_(1) {
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  constexpr int digits = 53;
  auto integer = static_cast<std::int64_t>(std::ldexp(significand, digits));
  exponent -= digits;
  for (; exponent < 0 && integer % 2 == 0 && integer != 0; ++exponent) integer /= 2;
  numerator_ = integer;
  if (integer == 0) return;
  if (exponent > 0)
    numerator_ <<= static_cast<unsigned>(exponent);
  else
    denominator_ <<= static_cast<unsigned>(-exponent);
}

void CppFraction::make_denominator_positive() {
  if (denominator_.sign() > 0) return;
  numerator_.backend().negate();
  denominator_.backend().negate();
}

CppFraction CppFraction::sum(const CppFraction& a, const CppFraction& b, bool is_difference) {
  const auto add = [is_difference](const CppInteger& x, const CppInteger& y) {
    return is_difference ? CppInteger(x - y) : CppInteger(x + y);
  };
  CppFraction r;
  if (is_power_of_two(a.denominator_) && is_power_of_two(b.denominator_)) {
    const std::size_t of_a = trailing_zeros(a.denominator_), of_b = trailing_zeros(b.denominator_);
    r.numerator_ = of_a < of_b   ? add(a.numerator_ << (of_b - of_a), b.numerator_)
                   : of_b < of_a ? add(a.numerator_, b.numerator_ << (of_a - of_b))
                                 : add(a.numerator_, b.numerator_);
    r.denominator_ = of_a < of_b ? b.denominator_ : a.denominator_;
    reduce_by_twos(r.numerator_, r.denominator_);
    return r;
  }
  const CppInteger common =
      a.denominator_ == b.denominator_ ? a.denominator_ : divisor_of(a.denominator_, b.denominator_);
  if (is_one(common)) {
    r.numerator_ = add(product(a.numerator_, b.denominator_), product(b.numerator_, a.denominator_));
    r.denominator_ = product(a.denominator_, b.denominator_);
    return r;
  }
  const CppInteger rest_a = exact_quotient(a.denominator_, common), rest_b = exact_quotient(b.denominator_, common);
  const CppInteger numerator = add(product(a.numerator_, rest_b), product(b.numerator_, rest_a));
  // What divides the numerator and the denominator divides `common`.
  const CppInteger divisor = divisor_of(numerator, common);
  r.numerator_ = without_factor(numerator, divisor);
  r.denominator_ = product(without_factor(common, divisor), product(rest_a, rest_b));
  return r;
}

CppFraction operator*(const CppFraction& a, const CppFraction& b) {
  CppFraction r;
  if (is_power_of_two(a.denominator_) && is_power_of_two(b.denominator_)) {
    r.numerator_ = a.numerator_ * b.numerator_;
    r.denominator_ = a.denominator_ << trailing_zeros(b.denominator_);
    reduce_by_twos(r.numerator_, r.denominator_);
    return r;
  }
  const CppInteger p = divisor_of(a.numerator_, b.denominator_), q = divisor_of(b.numerator_, a.denominator_);
  r.numerator_ = product(without_factor(a.numerator_, p), without_factor(b.numerator_, q));
  r.denominator_ = product(without_factor(a.denominator_, q), without_factor(b.denominator_, p));
  return r;
}

CppFraction operator/(const CppFraction& a, const CppFraction& b) {
  CppFraction inverse;
  inverse.numerator_ = b.denominator_;
  inverse.denominator_ = b.numerator_;
  inverse.make_denominator_positive();
  return a * inverse;
}

int CppFraction::compare(const CppFraction& b) const {
  if (sign() != b.sign()) return sign() < b.sign() ? -1 : 1;
  if (denominator_ == b.denominator_) return numerator_.compare(b.numerator_);
  return product(numerator_, b.denominator_).compare(product(b.numerator_, denominator_));
}

int CppFraction::compare(std::int64_t b) const {
  if (is_one(denominator_)) return numerator_.compare(b);
  return numerator_.compare(CppInteger(denominator_ * b));
}

std::string CppFraction::str() const {
  return is_one(denominator_) ? numerator_.str() : numerator_.str() + "/" + denominator_.str();
}

}  // namespace strata::detail
