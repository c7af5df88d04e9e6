#pragma once
#include <array>

#include "core/kernel/hyperplane.h"

namespace strata::bsp {

/// The determinant of D rows: D! times the signed size of the simplex that they span with the origin.
[[nodiscard]] inline Rational determinant(const std::array<RationalVector<1>, 1>& m) { return m[0][0]; }
[[nodiscard]] inline Rational determinant(const std::array<RationalVector<2>, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}
[[nodiscard]] inline Rational determinant(const std::array<RationalVector<3>, 3>& m) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]);
  }
  return sum;
}

}  // namespace strata::bsp
