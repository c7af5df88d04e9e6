#pragma once
#include <cmath>

#include "core/exact/two_sum.h"

namespace strata {

/// A product and its rounding error. The error is exact unless it underflows, or a factor is beyond 2^996: it is NaN
/// then. Source: Veltkamp 1968, Dekker 1971.
[[nodiscard]] inline WithRest dekker_product(double a, double b) {
  const auto split = [](double x) -> WithRest {  // 26 bits each
    const double c = 134217729.0 * x, high = c - (c - x);
    return {high, x - high};
  };
  const double p = a * b;
  const WithRest x = split(a), y = split(b);
  return {p, ((x.value * y.value - p) + x.value * y.rest + x.rest * y.value) + x.rest * y.rest};
}

/// The rounding error of p = ab: a double unless it underflows. Where p overflows, the error is infinite or NaN.
[[nodiscard]] inline double product_error(double a, double b, double p) {
#if defined(__MINGW32__) || defined(__wasm__)
  // fma() of MinGW's library rounds twice, of WASI's takes a hundred instructions.
  constexpr double large = 0x1p990, down = 0x1p-100, up = 0x1p100;
  if (std::abs(a) > large) return dekker_product(a * down, b * up).rest;
  if (std::abs(b) > large) return dekker_product(a * up, b * down).rest;
  static_cast<void>(p);
  return dekker_product(a, b).rest;
#else
  return std::fma(a, b, -p);
#endif
}

/// The remainder p - qb of a quotient q = p / b that was rounded: a double unless it underflows.
[[nodiscard]] inline double quotient_error(double p, double b, double q) {
  const double product = q * b;
  return (p - product) - product_error(q, b, product);
}

}  // namespace strata
