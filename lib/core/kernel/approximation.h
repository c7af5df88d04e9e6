#pragma once
#include <cmath>
#include <type_traits>

#include "core/kernel/filters.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

namespace strata {

/// The positions of symbolic points in a type with error bounds: Bounded for the first tier, DoubleDouble for the
/// second.

template <class Real>
[[nodiscard]] RealPoint<Real> as(const RealPoint<DoubleDouble>& p) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) return p;
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i].bounded();
  return r;
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_vertex(const InputComplex& input, std::uint32_t v) {
  const VertexPosition place = input.place(v);
  const auto& p = *place.nearest;
  if (place.has_doubles()) return {p[0], p[1], p[2]};
  if (place.meet != nullptr) return as<Real>(place.meet->at);
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = Bounded{p[i], std::abs(p[i]) * Bounded::rounding + Bounded::underflow};
    if constexpr (std::is_same_v<Real, DoubleDouble>)
      if (place.remainder != nullptr) r[i] = DoubleDouble(p[i], (*place.remainder)[i], 0);
  }
  return r;
}

/// p + t (q - p)
template <class Real>
[[nodiscard]] RealPoint<Real> along(const RealPoint<Real>& p, const RealPoint<Real>& q, const Real& t) {
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i] + t * (q[i] - p[i]);
  return r;
}

/// A point of a face's plane, and the plane's normal.
template <class Real>
struct ApproximatePlane {
  RealPoint<Real> at, normal;
};

template <class Real>
[[nodiscard]] ApproximatePlane<Real> approximate_plane(const InputComplex& input, std::uint32_t face) {
  if (const SourcePlane* source = input.source_plane(face)) {
    if constexpr (std::is_same_v<Real, DoubleDouble>)
      return {source->at(), source->normal()};
    else
      return {source->bounded_at(), source->bounded_normal()};
  }
  const auto f = input.face(face);
  const auto a = approximate_vertex<Real>(input, f[0]);
  return {a, cross<Real>(approximate_vertex<Real>(input, f[1]) - a, approximate_vertex<Real>(input, f[2]) - a)};
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_edge_face(const InputComplex& input, const SymbolicPoint& name) {
  const auto p = approximate_vertex<Real>(input, name.id[0]), q = approximate_vertex<Real>(input, name.id[1]);
  const auto plane = approximate_plane<Real>(input, name.id[2]);
  const Real sp = dot<Real>(plane.normal, p - plane.at), sq = dot<Real>(plane.normal, q - plane.at);
  // From the nearer end: the error is multiplied by the smaller distance.
  return std::abs(sp.value) <= std::abs(sq.value) ? along<Real>(p, q, sp / (sp - sq))
                                                  : along<Real>(q, p, sq / (sq - sp));
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_edge_edge(const InputComplex& input, const SymbolicPoint& name) {
  const auto p = approximate_vertex<Real>(input, name.id[0]), q = approximate_vertex<Real>(input, name.id[1]);
  const auto r = approximate_vertex<Real>(input, name.id[2]), s = approximate_vertex<Real>(input, name.id[3]);
  const auto n = cross<Real>(q - p, s - r), m = cross<Real>(r - p, s - r);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i].value) > std::abs(n[axis].value)) axis = i;
  return along<Real>(p, q, m[axis] / n[axis]);
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_three_faces(const InputComplex& input, const SymbolicPoint& name) {
  std::array<ApproximatePlane<Real>, 3> plane;
  for (std::size_t i = 0; i < 3; ++i) plane[i] = approximate_plane<Real>(input, name.id[i]);
  const auto& base = plane[0].at;
  const auto c0 = cross<Real>(plane[1].normal, plane[2].normal), c1 = cross<Real>(plane[2].normal, plane[0].normal),
             c2 = cross<Real>(plane[0].normal, plane[1].normal);
  const Real w = dot<Real>(plane[0].normal, c0);
  const Real d1 = dot<Real>(plane[1].normal, plane[1].at - base), d2 = dot<Real>(plane[2].normal, plane[2].at - base);
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = base[i] + (d1 * c1[i] + d2 * c2[i]) / w;
  return r;
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_weighted(const InputComplex& input, const SymbolicPoint& name) {
  const auto f = input.face(name.id[0]);
  const auto p = approximate_vertex<Real>(input, f[0]), q = approximate_vertex<Real>(input, f[1]),
             r = approximate_vertex<Real>(input, f[2]);
  const double t = name.id[1];
  RealPoint<Real> x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = p[i] + (Real(t) * (q[i] - p[i]) + Real(t * t) * (r[i] - p[i])) / Real(1 + t + t * t);
  return x;
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate(const InputComplex& input, const SymbolicPoint& name) {
  switch (name.kind) {
    case SymbolicPoint::Kind::input:
      return approximate_vertex<Real>(input, name.id[0]);
    case SymbolicPoint::Kind::edge_edge:
      return approximate_edge_edge<Real>(input, name);
    case SymbolicPoint::Kind::edge_face:
      return approximate_edge_face<Real>(input, name);
    case SymbolicPoint::Kind::three_faces:
      return approximate_three_faces<Real>(input, name);
    case SymbolicPoint::Kind::weighted:
      return approximate_weighted<Real>(input, name);
    case SymbolicPoint::Kind::free:
      break;
  }
  return {};
}

}  // namespace strata
