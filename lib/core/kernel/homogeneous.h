#pragma once
#include <type_traits>
#include <utility>

#include "core/exact/lattice.h"
#include "core/exact/sign.h"

namespace strata {

/// Homogeneous geometry over any ring of exact integers. theory.md, "Widths", bounds every result.

/// The point (x, y, z) / w with w > 0; `unit` means w = 1.
template <class Int>
struct HPoint {
  Int x, y, z, w;
  bool unit = true;

  const Int& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// The plane a x + b y + c z + d w = 0; positive on the outer side.
template <class Int>
struct HPlane {
  Int a, b, c, d;
};

template <class Int>
[[nodiscard]] Int weighed(const Int& k, const HPoint<Int>& p) {
  return p.unit ? k : Int(k * p.w);
}

/// Plane through three points, positive where they are seen counter-clockwise. Zero normal when collinear.
template <class Int>
[[nodiscard]] HPlane<Int> plane_through(const HPoint<Int>& p, const HPoint<Int>& q, const HPoint<Int>& r) {
  const Int ux = weighed(q.x, p) - weighed(p.x, q), vx = weighed(r.x, p) - weighed(p.x, r);
  const Int uy = weighed(q.y, p) - weighed(p.y, q), vy = weighed(r.y, p) - weighed(p.y, r);
  const Int uz = weighed(q.z, p) - weighed(p.z, q), vz = weighed(r.z, p) - weighed(p.z, r);
  const Int a = uy * vz - uz * vy, b = uz * vx - ux * vz, c = ux * vy - uy * vx;
  const Int d = -(a * p.x + b * p.y + c * p.z);
  return {weighed(a, p), weighed(b, p), weighed(c, p), d};
}

/// Plane through the points p and q that is parallel to a coordinate axis.
template <class Int>
[[nodiscard]] HPlane<Int> plane_along_axis(const HPoint<Int>& p, const HPoint<Int>& q, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Int ui = weighed(q[i], p) - weighed(p[i], q);
  const Int uj = weighed(q[j], p) - weighed(p[j], q);
  const Int d = -(uj * p[i] - ui * p[j]);
  const Int ni = weighed(uj, p), nj = -weighed(ui, p);
  if (axis == 0) return {Int(0), ni, nj, d};
  if (axis == 1) return {nj, Int(0), ni, d};
  return {ni, nj, Int(0), d};
}

/// Value of a plane's linear form at a point: its sign is the side.
template <class Int>
[[nodiscard]] Int value_at(const HPlane<Int>& plane, const HPoint<Int>& p) {
  return plane.a * p.x + plane.b * p.y + plane.c * p.z + weighed(plane.d, p);
}

/// True for a LongInt that could not represent its value and has no sign.
template <class Int>
[[nodiscard]] bool is_lost(const Int& x) {
  if constexpr (std::is_same_v<Int, LongInt>) return x.is_lost();
  return false;
}

/// A homogeneous point with positive weight. w = 0 (no single point) and lost values are unchanged.
template <class Int>
[[nodiscard]] HPoint<Int> with_positive_weight(Int x, Int y, Int z, Int w) {
  if (!is_lost(w) && sign_of_integer(w) == Sign::negative)
    return {-std::move(x), -std::move(y), -std::move(z), -std::move(w), false};
  return {std::move(x), std::move(y), std::move(z), std::move(w), false};
}

/// Where the line pq meets a plane.
template <class Int>
[[nodiscard]] HPoint<Int> meet(const HPoint<Int>& p, const HPoint<Int>& q, const HPlane<Int>& plane) {
  const Int sp = value_at(plane, p), sq = value_at(plane, q);
  return with_positive_weight<Int>(sq * p.x - sp * q.x, sq * p.y - sp * q.y, sq * p.z - sp * q.z,
                                   weighed(sq, p) - weighed(sp, q));
}

/// Where three planes meet.
template <class Int>
[[nodiscard]] HPoint<Int> meet(const HPlane<Int>& f, const HPlane<Int>& g, const HPlane<Int>& h) {
  const Int x1 = g.b * h.c - g.c * h.b, y1 = g.c * h.a - g.a * h.c, z1 = g.a * h.b - g.b * h.a;
  const Int x2 = h.b * f.c - h.c * f.b, y2 = h.c * f.a - h.a * f.c, z2 = h.a * f.b - h.b * f.a;
  const Int x3 = f.b * g.c - f.c * g.b, y3 = f.c * g.a - f.a * g.c, z3 = f.a * g.b - f.b * g.a;
  return with_positive_weight<Int>(-(f.d * x1 + g.d * x2 + h.d * x3), -(f.d * y1 + g.d * y2 + h.d * y3),
                                   -(f.d * z1 + g.d * z2 + h.d * z3), f.a * x1 + f.b * y1 + f.c * z1);
}

/// Twice the signed area of p, q, r seen along two axes, times a positive factor.
template <class Int>
[[nodiscard]] Int orientation(const HPoint<Int>& p, const HPoint<Int>& q, const HPoint<Int>& r, int u, int v) {
  if (p.unit && q.unit && r.unit) return (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
  const Int qr = q[u] * r[v] - q[v] * r[u], rp = r[u] * p[v] - r[v] * p[u], pq = p[u] * q[v] - p[v] * q[u];
  return weighed(qr, p) + weighed(rp, q) + weighed(pq, r);
}

}  // namespace strata
