#include "extensions/contact/root.h"

#include "core/exact/scaled_root.h"

namespace strata::contact {

double root(const Rational& x) {
  if (x.sign() <= 0) return 0;
  // x 4^k is about 2^128: the floor of its root has 64 bits, 11 more than doubles.
  const long size = binary_size(x), k = (128 - size + (size & 1)) / 2;
  Rational r = scaled_root(x, k);
  const Integer power = Integer(1) << static_cast<unsigned long>(k >= 0 ? k : -k);
  if (k >= 0)
    r /= power;
  else
    r *= power;
  return to_nearest_double(r);
}

}  // namespace strata::contact
