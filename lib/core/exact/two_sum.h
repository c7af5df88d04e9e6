#pragma once

namespace strata {

/// A rounded result, and what is missing from it to the exact one.
struct WithRest {
  double value, rest;
};

/// a + b. The rest is a double whatever the sizes of a and b; where the sum overflows, it is NaN.
/// Source: Knuth 1997, volume 2, 4.2.2, theorem B.
[[nodiscard]] inline WithRest two_sum(double a, double b) {
  const double s = a + b, b_used = s - a;
  return {s, (a - (s - b_used)) + (b - b_used)};
}

/// The same in half the steps. Requires |a| >= |b| or a = 0. Source: Dekker 1971.
[[nodiscard]] inline WithRest quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

}  // namespace strata
