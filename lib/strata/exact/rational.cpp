#include "strata/exact/rational.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata {
namespace {

std::size_t bit_length(const Integer& positive) { return mpz_sizeinbase(positive.backend().data(), 2); }

/// floor(log2(n / d)) for positive n and d.
long floor_log2(const Integer& n, const Integer& d) {
  const long estimate = static_cast<long>(bit_length(n)) - static_cast<long>(bit_length(d));  // right or one too large
  const bool reached = estimate >= 0 ? n >= (d << estimate) : (n << -estimate) >= d;
  return reached ? estimate : estimate - 1;
}

/// The integer nearest to n / d / 2^scale for positive n and d; ties to even.
Integer nearest_multiple(Integer n, Integer d, long scale) {
  if (scale >= 0) {
    d <<= scale;
  } else {
    n <<= -scale;
  }
  Integer quotient;
  Integer remainder;
  divide_qr(n, d, quotient, remainder);
  const int half = Integer(remainder << 1).compare(d);
  if (half > 0 || (half == 0 && bit_test(quotient, 0))) ++quotient;
  return quotient;
}

/// The Float nearest to q. The significand is rounded once, at the last bit that the exponent of q leaves to it;
/// what follows is exact or overflows to infinity. Values that round to zero give +0.
template <class Float>
Float to_nearest(const Rational& q) {
  using Limits = std::numeric_limits<Float>;
  const int sign = q.sign();
  if (sign == 0) return 0;
  const Integer n = abs(numerator(q));
  const Integer d = denominator(q);
  if (bit_length(n) <= Limits::digits && bit_length(d) <= Limits::digits) {  // one IEEE division, far from subnormals
    const Float quotient = n.convert_to<Float>() / d.convert_to<Float>();
    return sign < 0 ? -quotient : quotient;
  }
  const long exponent = floor_log2(n, d);
  if (exponent >= Limits::max_exponent) return sign < 0 ? -Limits::infinity() : Limits::infinity();
  const long lowest_bit = Limits::min_exponent - Limits::digits;  // of the subnormals
  if (exponent < lowest_bit - 1) return 0;
  const long last_bit = std::max(exponent - Limits::digits + 1, lowest_bit);
  const Float significand = nearest_multiple(n, d, last_bit).convert_to<Float>();
  const Float magnitude = std::ldexp(significand, static_cast<int>(last_bit));
  return sign < 0 && magnitude != 0 ? -magnitude : magnitude;
}

}  // namespace

double to_nearest_double(const Rational& q) { return to_nearest<double>(q); }

float to_nearest_float(const Rational& q) { return to_nearest<float>(q); }

Rational to_rational(double x) {
  Rational q;
  mpq_set_d(q.backend().data(), x);
  return q;
}

}  // namespace strata
