#include "extensions/contact/root.h"

namespace strata::contact {

double root(const Rational& x) {
  if (x.sign() <= 0) return 0;
  const Integer n = numerator(x), d = denominator(x);
  // An even power of two that makes the quotient about 2^128: the floor of its root has 64 bits, 11 more than doubles.
  auto shift = 128 - (static_cast<long>(bit_length(n)) - static_cast<long>(bit_length(d)));
  shift += shift & 1;
  const Integer quotient = shift >= 0 ? Integer((n << static_cast<unsigned long>(shift)) / d)
                                      : Integer(n / (d << static_cast<unsigned long>(-shift)));
  Rational r = sqrt(quotient);
  const long half = shift / 2;
  const Integer power = Integer(1) << static_cast<unsigned long>(half >= 0 ? half : -half);
  if (half >= 0)
    r /= power;
  else
    r *= power;
  return to_nearest_double(r);
}

}  // namespace strata::contact
