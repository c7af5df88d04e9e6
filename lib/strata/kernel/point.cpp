#include "strata/kernel/point.h"

#include <algorithm>
#include <cmath>

#include "strata/exact/twofold.h"
#include "strata/kernel/exact_evaluation.h"
#include "strata/kernel/filters.h"

namespace strata {
namespace {

bool has(const Carriers::Indices& v, std::uint32_t x) { return v[0] == x || v[1] == x || v[2] == x; }

template <class Real>
RealPoint<Real> approximate_vertex(const Carriers& carriers, std::uint32_t v) {
  const auto& p = carriers.vertex(v);
  if (carriers.exact(v) == nullptr) return {p[0], p[1], p[2]};
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = Bounded{p[i], std::abs(p[i]) * Bounded::rounding + Bounded::underflow};
  return r;
}

/// p + t (q - p)
template <class Real>
RealPoint<Real> along(const RealPoint<Real>& p, const RealPoint<Real>& q, const Real& t) {
  RealPoint<Real> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i] + t * (q[i] - p[i]);
  return r;
}

/// A point of a face's plane, and the plane's normal.
template <class Real>
struct Plane {
  RealPoint<Real> at, normal;
};

template <class Real>
Plane<Real> approximate_plane(const Carriers& carriers, std::uint32_t face) {
  const auto f = carriers.face(face);
  const auto a = approximate_vertex<Real>(carriers, f[0]);
  return {a, cross<Real>(approximate_vertex<Real>(carriers, f[1]) - a, approximate_vertex<Real>(carriers, f[2]) - a)};
}

template <class Real>
RealPoint<Real> approximate_edge_face(const Carriers& carriers, const PointName& name) {
  const auto p = approximate_vertex<Real>(carriers, name.id[0]), q = approximate_vertex<Real>(carriers, name.id[1]);
  const auto plane = approximate_plane<Real>(carriers, name.id[2]);
  const Real sp = dot<Real>(plane.normal, p - plane.at), sq = dot<Real>(plane.normal, q - plane.at);
  // From the nearer end: the error is carried over the shorter way.
  return std::abs(sp.value) <= std::abs(sq.value) ? along<Real>(p, q, sp / (sp - sq))
                                                  : along<Real>(q, p, sq / (sq - sp));
}

template <class Real>
RealPoint<Real> approximate_edge_edge(const Carriers& carriers, const PointName& name) {
  const auto p = approximate_vertex<Real>(carriers, name.id[0]), q = approximate_vertex<Real>(carriers, name.id[1]);
  const auto r = approximate_vertex<Real>(carriers, name.id[2]), s = approximate_vertex<Real>(carriers, name.id[3]);
  const auto n = cross<Real>(q - p, s - r), m = cross<Real>(r - p, s - r);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i].value) > std::abs(n[axis].value)) axis = i;
  return along<Real>(p, q, m[axis] / n[axis]);
}

template <class Real>
RealPoint<Real> approximate_three_faces(const Carriers& carriers, const PointName& name) {
  std::array<Plane<Real>, 3> plane;
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
RealPoint<Real> approximate_weighted(const Carriers& carriers, const PointName& name) {
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
RealPoint<Real> approximate(const Carriers& carriers, const PointName& name) {
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

/// Wide bounds make every later decision dear: bounds beyond 2^-49 of the largest coordinate are made narrower. So are
/// overflows, whose infinite bounds no later decision could use.
bool is_tight(const BoundedPoint& p) {
  const double size = std::max({std::abs(p[0].value), std::abs(p[1].value), std::abs(p[2].value), 0x1p-900});
  for (const Bounded& x : p)
    if (!std::isfinite(x.value) || !(x.error <= size * 0x1p-49)) return false;
  return true;
}

Carriers::Coordinates nearest_exact(const Carriers& carriers, const Point& point) {
  const RationalPoint exact = exact_position(carriers, point);
  return {to_nearest_double(exact[0]), to_nearest_double(exact[1]), to_nearest_double(exact[2])};
}

}  // namespace

bool named_on_face(const PointName& name, std::uint32_t f, const Carriers::Indices& v) {
  const auto& id = name.id;
  switch (name.kind) {
    case PointName::Kind::input:
      return has(v, id[0]);
    case PointName::Kind::edge_edge:
      return (has(v, id[0]) && has(v, id[1])) || (has(v, id[2]) && has(v, id[3]));
    case PointName::Kind::edge_face:
      return id[2] == f || (has(v, id[0]) && has(v, id[1]));
    case PointName::Kind::three_faces:
      return id[0] == f || id[1] == f || id[2] == f;
    case PointName::Kind::weighted:
      return id[0] == f;
    case PointName::Kind::free:
      return false;
  }
  return false;
}

bool named_on_edge(const PointName& name, std::uint32_t a, std::uint32_t b) {
  const auto& id = name.id;
  const auto is = [&](std::uint32_t c, std::uint32_t d) { return (a == c && b == d) || (a == d && b == c); };
  switch (name.kind) {
    case PointName::Kind::input:
      return id[0] == a || id[0] == b;
    case PointName::Kind::edge_edge:
      return is(id[0], id[1]) || is(id[2], id[3]);
    case PointName::Kind::edge_face:
      return is(id[0], id[1]);
    case PointName::Kind::three_faces:
    case PointName::Kind::weighted:
    case PointName::Kind::free:
      return false;
  }
  return false;
}

Point make_point(const Carriers& carriers, const PointName& name) {
  Point p{name, approximate<Bounded>(carriers, name)};
  if (name.kind == PointName::Kind::input || is_tight(p.at)) return p;
  const auto finer = approximate<Twofold>(carriers, name);
  for (std::size_t i = 0; i < 3; ++i) p.at[i] = finer[i].bounded();
  if (is_tight(p.at)) return p;
  const auto nearest = nearest_exact(carriers, p);
  for (std::size_t i = 0; i < 3; ++i)
    p.at[i] = {nearest[i], std::abs(nearest[i]) * Bounded::rounding + Bounded::underflow};
  return p;
}

RationalPoint exact_position(const Carriers& carriers, const Point& point) {
  const Point* const one[] = {&point};
  const Ground ground(carriers, one);
  const HPoint<Integer> h = ExactEvaluation<Integer>(carriers, ground.lattice()).point(point);
  const int unit = ground.lattice().unit();
  RationalPoint r;
  for (int i = 0; i < 3; ++i) {
    Integer n = h[i], d = h.w;
    if (unit > 0) n <<= static_cast<unsigned>(unit);
    if (unit < 0) d <<= static_cast<unsigned>(-unit);
    r[static_cast<std::size_t>(i)] = Rational(n, d);
  }
  return r;
}

Carriers::Coordinates nearest_doubles(const Carriers& carriers, const Point& point) {
  if (point.name.kind == PointName::Kind::input) return carriers.vertex(point.name.id[0]);
  if (point.name.kind == PointName::Kind::free) return {point.at[0].value, point.at[1].value, point.at[2].value};
  const auto fine = approximate<Twofold>(carriers, point.name);
  if (fine[0].rounds_to_value() && fine[1].rounds_to_value() && fine[2].rounds_to_value())
    return {fine[0].value, fine[1].value, fine[2].value};
  return nearest_exact(carriers, point);
}

}  // namespace strata
