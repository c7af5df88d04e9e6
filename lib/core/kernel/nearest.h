#pragma once
#include "core/exact/double_double.h"
#include "strata/rational.h"

namespace strata {

/// The nearest double, and the double nearest to the rounding error.
[[nodiscard]] inline DoubleDouble nearest_double_double(const Rational& x) {
  const double value = to_nearest_double(x);
  if (!std::isfinite(value)) return {value, 0, HUGE_VAL};
  const double low = to_nearest_double(x - to_rational(value));
  return {value, low, std::abs(low) * Bounded::rounding + Bounded::underflow};
}

}  // namespace strata
