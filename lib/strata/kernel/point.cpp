#include "strata/kernel/point.h"

#include <cmath>

#include "strata/kernel/exact_evaluation.h"
#include "strata/kernel/filters.h"

namespace strata {
namespace {

bool has(const Carriers::Indices& v, std::uint32_t x) { return v[0] == x || v[1] == x || v[2] == x; }

BoundedPoint approximate_vertex(const Carriers& carriers, std::uint32_t v) {
  const auto& p = carriers.vertex(v);
  if (carriers.exact(v) == nullptr) return {p[0], p[1], p[2]};
  BoundedPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = {p[i], std::abs(p[i]) * Bounded::rounding + Bounded::underflow};
  return r;
}

/// p + t (q - p)
BoundedPoint along(const BoundedPoint& p, const BoundedPoint& q, Bounded t) {
  BoundedPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = p[i] + t * (q[i] - p[i]);
  return r;
}

BoundedPoint approximate_edge_face(const Carriers& carriers, const PointName& name) {
  const BoundedPoint p = approximate_vertex(carriers, name.id[0]), q = approximate_vertex(carriers, name.id[1]);
  const auto f = carriers.face(name.id[2]);
  const BoundedPoint a = approximate_vertex(carriers, f[0]);
  const BoundedPoint n = cross(approximate_vertex(carriers, f[1]) - a, approximate_vertex(carriers, f[2]) - a);
  const Bounded sp = dot(n, p - a), sq = dot(n, q - a);
  // From the nearer end: the error is carried over the shorter way.
  return std::abs(sp.value) <= std::abs(sq.value) ? along(p, q, sp / (sp - sq)) : along(q, p, sq / (sq - sp));
}

BoundedPoint approximate_edge_edge(const Carriers& carriers, const PointName& name) {
  const BoundedPoint p = approximate_vertex(carriers, name.id[0]), q = approximate_vertex(carriers, name.id[1]);
  const BoundedPoint r = approximate_vertex(carriers, name.id[2]), s = approximate_vertex(carriers, name.id[3]);
  const BoundedPoint n = cross(q - p, s - r);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i].value) > std::abs(n[axis].value)) axis = i;
  const BoundedPoint m = cross(r - p, s - r);
  return along(p, q, m[axis] / n[axis]);
}

BoundedPoint approximate_three_faces(const Carriers& carriers, const PointName& name) {
  const BoundedPoint base = approximate_vertex(carriers, carriers.face(name.id[0])[0]);
  std::array<BoundedPoint, 3> n;
  std::array<Bounded, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto f = carriers.face(name.id[i]);
    const BoundedPoint a = approximate_vertex(carriers, f[0]);
    n[i] = cross(approximate_vertex(carriers, f[1]) - a, approximate_vertex(carriers, f[2]) - a);
    d[i] = dot(n[i], a - base);
  }
  const BoundedPoint c0 = cross(n[1], n[2]), c1 = cross(n[2], n[0]), c2 = cross(n[0], n[1]);
  const Bounded w = dot(n[0], c0);
  BoundedPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = base[i] + (d[0] * c0[i] + d[1] * c1[i] + d[2] * c2[i]) / w;
  return r;
}

BoundedPoint approximate_weighted(const Carriers& carriers, const PointName& name) {
  const auto f = carriers.face(name.id[0]);
  const BoundedPoint p = approximate_vertex(carriers, f[0]), q = approximate_vertex(carriers, f[1]),
                     r = approximate_vertex(carriers, f[2]);
  const double t = name.id[1];
  BoundedPoint x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = p[i] + (Bounded(t) * (q[i] - p[i]) + Bounded(t * t) * (r[i] - p[i])) / Bounded(1 + t + t * t);
  return x;
}

BoundedPoint approximate(const Carriers& carriers, const PointName& name) {
  switch (name.kind) {
    case PointName::Kind::input:
      return approximate_vertex(carriers, name.id[0]);
    case PointName::Kind::edge_edge:
      return approximate_edge_edge(carriers, name);
    case PointName::Kind::edge_face:
      return approximate_edge_face(carriers, name);
    case PointName::Kind::three_faces:
      return approximate_three_faces(carriers, name);
    case PointName::Kind::weighted:
      return approximate_weighted(carriers, name);
    case PointName::Kind::free:
      break;
  }
  return {};
}

/// Wide bounds make every later decision dear: beyond 2^-24 of the coordinate they are replaced by the exact place.
/// So are overflows, whose infinite bounds no later decision could use.
bool is_tight(const BoundedPoint& p) {
  for (const Bounded& x : p)
    if (!std::isfinite(x.value) || !(x.error <= std::max(std::abs(x.value) * 0x1p-24, 0x1p-900))) return false;
  return true;
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
  Point p{name, approximate(carriers, name)};
  if (name.kind == PointName::Kind::input || is_tight(p.at)) return p;
  const auto nearest = nearest_doubles(carriers, p);
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
  const RationalPoint exact = exact_position(carriers, point);
  return {to_nearest_double(exact[0]), to_nearest_double(exact[1]), to_nearest_double(exact[2])};
}

}  // namespace strata
