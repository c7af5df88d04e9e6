#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/exact/lattice.h"
#include "core/exact/sign.h"
#include "core/exact/vector.h"
#include "extensions/convex/surface.h"

// Vectors of integers, and signs of their products, for Gauss maps. theory.md, "Minkowski sums", "Bits".
namespace strata::convex {

template <class N>
using Triple = std::array<N, 3>;

[[nodiscard]] constexpr int sign_number(__int128 x) { return (x > 0) - (x < 0); }
template <int Limbs>
[[nodiscard]] constexpr int sign_number(const WideInt<Limbs>& x) {
  return to_int(x.sign());
}
[[nodiscard]] inline int sign_number(const Integer& x) { return x.sign(); }

/// The value with a relative error of at most 2^-52; infinite beyond the doubles.
[[nodiscard]] inline double nearly(__int128 x) { return static_cast<double>(x); }
template <int Limbs>
[[nodiscard]] double nearly(const WideInt<Limbs>& x) {
  const bool is_negative = x.sign() == Sign::negative;
  const auto limbs = (is_negative ? -x : x).limbs();
  int top = Limbs - 1;
  while (top > 0 && limbs[top] == 0) --top;
  // The limbs below the two highest contribute less than 2^-64 of the value.
  double r = std::ldexp(static_cast<double>(limbs[top]), 64 * top);
  if (top > 0) {
    const auto two = static_cast<unsigned __int128>(limbs[top]) << 64 | limbs[top - 1];
    r = std::ldexp(static_cast<double>(two), 64 * (top - 1));
  }
  return is_negative ? -r : r;
}
[[nodiscard]] inline double nearly(const Integer& x) {
  constexpr std::size_t largest = 1023;
  if (bit_length(x) > largest) return x.sign() * std::numeric_limits<double>::infinity();
  return x.to_double();
}

/// Integer vectors with their values in doubles.
template <class N>
struct Vectors {
  std::vector<Triple<N>> exact;
  std::vector<std::array<double, 3>> approximate;

  void add(Triple<N> v) {
    approximate.push_back({nearly(v[0]), nearly(v[1]), nearly(v[2])});
    exact.push_back(std::move(v));
  }
  [[nodiscard]] std::size_t size() const { return exact.size(); }
};

/// Sign of the scalar product of two vectors of integers, exact. Each computed product has a relative error below
/// (1 + 2^-52)^2 (1 + 2^-53) - 1 < 2.6 * 2^-51, the two sums add less than 2^-52 of the sum of sizes, whose own
/// rounding is as small: 16 * 2^-53 of it is more than all. Integers do not underflow; overflow decides nothing.
template <class N>
[[nodiscard]] int product_sign(const Vectors<N>& a, std::size_t i, const Vectors<N>& b, std::size_t j) {
  const auto &u = a.approximate[i], &v = b.approximate[j];
  const double x = u[0] * v[0], y = u[1] * v[1], z = u[2] * v[2];
  const double value = x + y + z, bound = 16 * 0x1p-53 * (std::abs(x) + std::abs(y) + std::abs(z));
  if (value > bound) return 1;
  if (-value > bound) return -1;
  if (bound == 0) return 0;
  return sign_number(dot(a.exact[i], b.exact[j]));
}

/// The sign of the first product of components in different axes that is not zero. It decides a scalar product that is
/// zero, after an infinitesimal transformation of the second vector (theory.md, "Minkowski sums"). Not zero for
/// perpendicular vectors that are not zero: if u_i v_j = 0 for all i != j, both lie along one axis or one is zero.
[[nodiscard]] inline int infinitesimal_sign(const std::array<double, 3>& u, const std::array<double, 3>& v) {
  constexpr std::array<std::array<std::size_t, 2>, 6> order{{{0, 1}, {1, 2}, {2, 0}, {1, 0}, {2, 1}, {0, 2}}};
  for (const auto& [i, j] : order)
    if (u[i] != 0 && v[j] != 0) return (u[i] > 0) == (v[j] > 0) ? 1 : -1;
  return 0;
}

/// Normals of faces, directions of edges, and the convexity of edges, of a surface on its own lattice.
template <class N>
struct Directions {
  Vectors<N> normals;             ///< of faces, outwards
  Vectors<N> edges;               ///< from `from` to `to`
  Vectors<N> towards;             ///< per edge two: from `from` to the third corners of left and right
  std::vector<signed char> bend;  ///< per edge: 1 convex, 0 flat, -1 reflex
};

/// Coordinates as integers in a common unit, and their number of bits: |x| < 2^bits.
struct LatticePoints {
  std::vector<Triple<Integer>> points;
  int bits = 1;
};

/// O(n), with rational arithmetic where there are rationals. Throws Cancelled.
[[nodiscard]] LatticePoints lattice_points(ExactMeshView points, const Monitor& monitor = {});

/// O(n). Throws Cancelled.
template <class N>
[[nodiscard]] Directions<N> directions_of(const Surface& surface, const LatticePoints& lattice, const Monitor& monitor);

extern template Directions<__int128> directions_of(const Surface&, const LatticePoints&, const Monitor&);
extern template Directions<WideInt<4>> directions_of(const Surface&, const LatticePoints&, const Monitor&);
extern template Directions<Integer> directions_of(const Surface&, const LatticePoints&, const Monitor&);

}  // namespace strata::convex
