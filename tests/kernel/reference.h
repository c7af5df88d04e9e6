#pragma once
#include <optional>

#include "core/exact/sign.h"
#include "strata/rational.h"

namespace strata::test {

/// Rational geometry straight from the definitions: what the kernel is compared with. It shares nothing with it.

inline RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline Rational dot(const RationalPoint& u, const RationalPoint& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline bool is_zero(const RationalPoint& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// Determinant of three columns, by the rule of Sarrus.
inline Rational determinant(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return a[0] * b[1] * c[2] + b[0] * c[1] * a[2] + c[0] * a[1] * b[2] - c[0] * b[1] * a[2] - b[0] * a[1] * c[2] -
         a[0] * c[1] * b[2];
}

/// p + t (q - p)
inline RationalPoint at_parameter(const RationalPoint& p, const RationalPoint& q, const Rational& t) {
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
}

/// Three corners and what follows from them.
struct RationalPlane {
  RationalPoint a, b, c;

  [[nodiscard]] RationalPoint normal() const { return cross(b - a, c - a); }
  [[nodiscard]] Sign side(const RationalPoint& p) const { return sign_of(dot(normal(), p - a)); }
};

/// Where the lines pq and rs meet in exactly one point: the parameter that minimizes the distance, if that is zero.
inline std::optional<RationalPoint> line_meets_line(const RationalPoint& p, const RationalPoint& q,
                                                    const RationalPoint& r, const RationalPoint& s) {
  const RationalPoint n = cross(q - p, s - r);
  if (is_zero(n) || dot(n, r - p) != 0) return std::nullopt;
  return at_parameter(p, q, dot(cross(r - p, s - r), n) / dot(n, n));
}

inline std::optional<RationalPoint> line_meets_plane(const RationalPoint& p, const RationalPoint& q,
                                                     const RationalPlane& f) {
  const RationalPoint n = f.normal();
  const Rational slope = dot(n, q - p);
  if (slope == 0) return std::nullopt;
  return at_parameter(p, q, dot(n, f.a - p) / slope);
}

/// Cramer's rule on n . x = n . a.
inline std::optional<RationalPoint> planes_meet(const RationalPlane& f, const RationalPlane& g,
                                                const RationalPlane& h) {
  const RationalPoint l = f.normal(), m = g.normal(), n = h.normal();
  const RationalPoint x{l[0], m[0], n[0]}, y{l[1], m[1], n[1]}, z{l[2], m[2], n[2]};
  const RationalPoint right{dot(l, f.a), dot(m, g.a), dot(n, h.a)};
  const Rational whole = determinant(x, y, z);
  if (whole == 0) return std::nullopt;
  return RationalPoint{determinant(right, y, z) / whole, determinant(x, right, z) / whole,
                       determinant(x, y, right) / whole};
}

/// (p + t q + t^2 r) / (1 + t + t^2)
inline RationalPoint weighted_mean(const RationalPlane& f, std::uint32_t weight) {
  const Rational t = weight, sum = 1 + t + t * t;
  RationalPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = (f.a[i] + t * f.b[i] + t * t * f.c[i]) / sum;
  return r;
}

inline Rational twice_area(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, int u, int v) {
  const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
  return (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
}

}  // namespace strata::test
