#pragma once
#include <array>
#include <cstddef>

#include "core/exact/double_double.h"

/// Structural zeros: zeros of orient3d and orient2d that follow from equal coordinates; theory.md, "Zeros without
/// integers".
namespace strata {

/// Certainly equal: equal doubles, or equal double-doubles without an error.
[[nodiscard]] inline bool is_same(double a, double b) { return a == b; }
[[nodiscard]] inline bool is_same(const DoubleDouble& a, const DoubleDouble& b) {
  return a.value == b.value && a.low == b.low && a.error == 0 && b.error == 0;
}
template <class Real>
[[nodiscard]] bool is_same(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return is_same(a[0], b[0]) && is_same(a[1], b[1]) && is_same(a[2], b[2]);
}

/// True when ab and cd run along that axis, or are points.
template <class Real>
[[nodiscard]] bool are_along(std::size_t axis, const std::array<Real, 3>& a, const std::array<Real, 3>& b,
                             const std::array<Real, 3>& c, const std::array<Real, 3>& d) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return is_same(a[u], b[u]) && is_same(a[v], b[v]) && is_same(c[u], d[u]) && is_same(c[v], d[v]);
}

/// True when equal coordinates show that the four points are coplanar: two points are equal, all four lie in a plane
/// perpendicular to an axis, or two pairs of points span lines parallel to the same axis.
template <class Real>
[[nodiscard]] bool show_common_plane(const std::array<Real, 3>& a, const std::array<Real, 3>& b,
                                     const std::array<Real, 3>& c, const std::array<Real, 3>& d) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_same(a[i], b[i]) && is_same(a[i], c[i]) && is_same(a[i], d[i])) return true;
    if (are_along(i, a, b, c, d) || are_along(i, a, c, b, d) || are_along(i, a, d, b, c)) return true;
  }
  return is_same(a, d) || is_same(b, d) || is_same(c, d) || is_same(a, c) || is_same(b, c) || is_same(a, b);
}

/// True when equal coordinates show that the three points are collinear: both products of the determinant vanish, or
/// two points are equal.
template <class Real>
[[nodiscard]] bool show_common_line(const std::array<Real, 2>& p, const std::array<Real, 2>& q,
                                    const std::array<Real, 2>& r) {
  if ((is_same(q[0], p[0]) || is_same(r[1], p[1])) && (is_same(q[1], p[1]) || is_same(r[0], p[0]))) return true;
  return is_same(q[0], r[0]) && is_same(q[1], r[1]);
}

}  // namespace strata
