#pragma once
#include <cmath>
#include <limits>

#include "core/exact/two_sum.h"

namespace strata {

/// A product and its rounding error. The error is exact unless it underflows; where a factor is beyond 2^996, or the
/// product beyond 2^1022, it may be infinite or NaN. Source: Veltkamp 1968, Dekker 1971.
[[nodiscard]] inline WithRest dekker_product(double a, double b) {
  const auto split = [](double x) -> WithRest {  // 26 bits each
    const double c = 134217729.0 * x, high = c - (c - x);
    return {high, x - high};
  };
  const double p = a * b;
  const WithRest x = split(a), y = split(b);
  return {p, ((x.value * y.value - p) + x.value * y.rest + x.rest * y.value) + x.rest * y.rest};
}

/// The rounding error of p = ab by dekker_product(), for all factors. Where p overflows, it is NaN.
[[nodiscard]] inline double dekker_error(double a, double b, double p) {
  constexpr double large = 0x1p900, down = 0x1p-200, up = 0x1p200;
  if (!(std::abs(p) <= std::numeric_limits<double>::max())) return p - p;
  const bool is_a_larger = std::abs(a) > std::abs(b);
  const double larger = is_a_larger ? a : b, smaller = is_a_larger ? b : a;
  if (std::abs(p) > large) return dekker_product(larger * down, smaller).rest * up;
  if (std::abs(larger) > large) return dekker_product(larger * down, smaller * up).rest;
  return dekker_product(a, b).rest;
}

/// The rounding error of p = ab: a double unless it underflows. Where p overflows, the error is infinite or NaN.
[[nodiscard]] inline double product_error(double a, double b, double p) {
#if defined(__MINGW32__) || defined(__wasm__)
  return dekker_error(a, b, p);  // fma() of MinGW's library rounds twice, of WASI's takes a hundred instructions
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
