#pragma once
#include <array>

#include "core/exact/bounded.h"
#include "core/exact/vector.h"

namespace strata {

/// Predicates in running errors, on coordinate differences: the first tier. theory.md, "Filters".

/// Three coordinates of a type with error bounds: Bounded or DoubleDouble.
template <class Real>
using RealPoint = std::array<Real, 3>;
using BoundedPoint = RealPoint<Bounded>;

template <class Real>
[[nodiscard]] RealPoint<Real> operator-(const RealPoint<Real>& p, const RealPoint<Real>& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

/// ((q - p) x (r - p)) . (s - p)
template <class Real>
[[nodiscard]] Real orient3d_of(const RealPoint<Real>& p, const RealPoint<Real>& q, const RealPoint<Real>& r,
                               const RealPoint<Real>& s) {
  return dot<Real>(cross<Real>(q - p, r - p), s - p);
}

/// Twice the area of p, q, r seen along two axes.
template <class Real>
[[nodiscard]] Real orientation_of(const RealPoint<Real>& p, const RealPoint<Real>& q, const RealPoint<Real>& r, int u,
                                  int v) {
  const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
  return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
}

}  // namespace strata
