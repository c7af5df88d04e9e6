#pragma once
#include <cstdint>

#include "core/kernel/filters.h"

namespace strata::contact {

/// Distances of a feature of one triangle from a feature of another, by corners p of one and q of the other, in a type
/// with error bounds or in rationals. The closest points lie inside the features where all `inside` are positive: then
/// `squared` is over / under.
template <class Real>
struct FeatureDistance {
  std::array<Real, 4> inside;
  Real over, under;
  int conditions = 0;  ///< how many entries of `inside` are used
};

template <class Real>
[[nodiscard]] FeatureDistance<Real> vertex_vertex(const RealPoint<Real>& p, const RealPoint<Real>& q) {
  const RealPoint<Real> d = q - p;
  return {{}, dot<Real>(d, d), Real(1), 0};
}

template <class Real>
[[nodiscard]] FeatureDistance<Real> vertex_edge(const RealPoint<Real>& p, const RealPoint<Real>& a,
                                                const RealPoint<Real>& b) {
  const RealPoint<Real> d = b - a, x = cross<Real>(p - a, d);
  return {{dot<Real>(p - a, d), dot<Real>(b - p, d)}, dot<Real>(x, x), dot<Real>(d, d), 2};
}

template <class Real>
[[nodiscard]] FeatureDistance<Real> vertex_face(const RealPoint<Real>& p, const RealPoint<Real>& a,
                                                const RealPoint<Real>& b, const RealPoint<Real>& c) {
  const RealPoint<Real> n = cross<Real>(b - a, c - a);
  const auto along = [&](const RealPoint<Real>& u, const RealPoint<Real>& v) {
    return dot<Real>(n, cross<Real>(v - u, p - u));
  };
  const Real height = dot<Real>(n, p - a);
  return {{along(a, b), along(b, c), along(c, a)}, height * height, dot<Real>(n, n), 3};
}

template <class Real>
[[nodiscard]] FeatureDistance<Real> edge_edge(const RealPoint<Real>& p, const RealPoint<Real>& q,
                                              const RealPoint<Real>& a, const RealPoint<Real>& b) {
  const RealPoint<Real> d = q - p, e = b - a, n = cross<Real>(d, e), w = a - p;
  const Real nn = dot<Real>(n, n), s = dot<Real>(cross<Real>(w, e), n), t = dot<Real>(cross<Real>(w, d), n);
  const Real height = dot<Real>(n, w);
  return {{s, nn - s, t, nn - t}, height * height, nn, 4};
}

}  // namespace strata::contact
