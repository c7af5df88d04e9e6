#pragma once
#include <array>

namespace strata {

/// Vectors of three numbers of one type.

template <class N>
[[nodiscard]] std::array<N, 3> minus(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {N(a[0] - b[0]), N(a[1] - b[1]), N(a[2] - b[2])};
}

template <class N>
[[nodiscard]] std::array<N, 3> cross(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}

template <class N>
[[nodiscard]] N dot(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

}  // namespace strata
