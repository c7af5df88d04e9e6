#pragma once
#include <cmath>
#include <type_traits>

#include "core/kernel/carriers.h"
#include "core/kernel/filters.h"
#include "core/kernel/point.h"

namespace strata {

/// Named points in a type with error bounds: Bounded for the first look, Twofold for a finer one.

template <class Real>
[[nodiscard]] RealPoint<Real> as(const RealPoint<Twofold>& p) {
  if constexpr (std::is_same_v<Real, Twofold>) return p;
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i].bounded();
  return r;
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_vertex(const Carriers& carriers, std::uint32_t v) {
  const VertexPlace place = carriers.place(v);
  const auto& p = *place.nearest;
  if (place.has_doubles()) return {p[0], p[1], p[2]};
  if (place.meet != nullptr) return as<Real>(place.meet->at);
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = Bounded{p[i], std::abs(p[i]) * Bounded::rounding + Bounded::underflow};
    if constexpr (std::is_same_v<Real, Twofold>)
      if (place.remainder != nullptr) r[i] = Twofold(p[i], (*place.remainder)[i], 0);
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
[[nodiscard]] ApproximatePlane<Real> approximate_plane(const Carriers& carriers, std::uint32_t face) {
  if (const SourcePlane* source = carriers.source_plane(face)) {
    if constexpr (std::is_same_v<Real, Twofold>)
      return {source->at(), source->normal()};
    else
      return {source->bounded_at(), source->bounded_normal()};
  }
  const auto f = carriers.face(face);
  const auto a = approximate_vertex<Real>(carriers, f[0]);
  return {a, cross<Real>(approximate_vertex<Real>(carriers, f[1]) - a, approximate_vertex<Real>(carriers, f[2]) - a)};
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_edge_face(const Carriers& carriers, const PointName& name) {
  const auto p = approximate_vertex<Real>(carriers, name.id[0]), q = approximate_vertex<Real>(carriers, name.id[1]);
  const auto plane = approximate_plane<Real>(carriers, name.id[2]);
  const Real sp = dot<Real>(plane.normal, p - plane.at), sq = dot<Real>(plane.normal, q - plane.at);
  // From the nearer end: the error is carried over the shorter way.
  return std::abs(sp.value) <= std::abs(sq.value) ? along<Real>(p, q, sp / (sp - sq))
                                                  : along<Real>(q, p, sq / (sq - sp));
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_edge_edge(const Carriers& carriers, const PointName& name) {
  const auto p = approximate_vertex<Real>(carriers, name.id[0]), q = approximate_vertex<Real>(carriers, name.id[1]);
  const auto r = approximate_vertex<Real>(carriers, name.id[2]), s = approximate_vertex<Real>(carriers, name.id[3]);
  const auto n = cross<Real>(q - p, s - r), m = cross<Real>(r - p, s - r);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i].value) > std::abs(n[axis].value)) axis = i;
  return along<Real>(p, q, m[axis] / n[axis]);
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate_three_faces(const Carriers& carriers, const PointName& name) {
  std::array<ApproximatePlane<Real>, 3> plane;
  for (std::size_t i = 0; i < 3; ++i) plane[i] = approximate_plane<Real>(carriers, name.id[i]);
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
[[nodiscard]] RealPoint<Real> approximate_weighted(const Carriers& carriers, const PointName& name) {
  const auto f = carriers.face(name.id[0]);
  const auto p = approximate_vertex<Real>(carriers, f[0]), q = approximate_vertex<Real>(carriers, f[1]),
             r = approximate_vertex<Real>(carriers, f[2]);
  const double t = name.id[1];
  RealPoint<Real> x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = p[i] + (Real(t) * (q[i] - p[i]) + Real(t * t) * (r[i] - p[i])) / Real(1 + t + t * t);
  return x;
}

template <class Real>
[[nodiscard]] RealPoint<Real> approximate(const Carriers& carriers, const PointName& name) {
  switch (name.kind) {
    case PointName::Kind::input:
      return approximate_vertex<Real>(carriers, name.id[0]);
    case PointName::Kind::edge_edge:
      return approximate_edge_edge<Real>(carriers, name);
    case PointName::Kind::edge_face:
      return approximate_edge_face<Real>(carriers, name);
    case PointName::Kind::three_faces:
      return approximate_three_faces<Real>(carriers, name);
    case PointName::Kind::weighted:
      return approximate_weighted<Real>(carriers, name);
    case PointName::Kind::free:
      break;
  }
  return {};
}

}  // namespace strata
