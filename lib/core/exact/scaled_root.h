#pragma once
#include "strata/rational.h"

namespace strata {

/// The integer part of the square root of q 4^k: the root of q in units of 2^-k. Requires q >= 0. O(n^1.6) for n digits
/// of q 4^k.
[[nodiscard]] Integer scaled_root(const Rational& q, long k);

/// Binary digits of the numerator beyond those of the denominator: q is between 2^(n-1) and 2^(n+1). Requires q > 0.
[[nodiscard]] inline long binary_size(const Rational& q) {
  return static_cast<long>(bit_length(numerator(q))) - static_cast<long>(bit_length(denominator(q)));
}

}  // namespace strata
