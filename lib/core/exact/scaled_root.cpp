#include "core/exact/scaled_root.h"

namespace strata {

Integer scaled_root(const Rational& q, long k) {
  const auto shift = static_cast<std::size_t>(2 * (k >= 0 ? k : -k));
  const Integer n = numerator(q), d = denominator(q);
  return sqrt(k >= 0 ? (n << shift) / d : n / (d << shift));
}

}  // namespace strata
