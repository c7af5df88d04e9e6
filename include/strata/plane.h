#pragma once
/// Oriented planes with rational coefficients.
#include <utility>

#include "strata/rational.h"

namespace strata {

/// The plane of the points p with normal . p = offset. Points with a greater product are in front of it, those with a
/// smaller one behind it. Any positive multiple of both is the same plane. Doubles are taken as the rationals they are:
/// `Plane{{0, 0, 1}, 0.5}`. No invariant: what needs a plane throws std::invalid_argument where the normal is zero.
struct Plane {
  RationalPoint normal;
  Rational offset;

  Plane(RationalPoint n, Rational d) : normal(std::move(n)), offset(std::move(d)) {}

  /// Through three points, which are counter-clockwise as seen from in front: the normal is (b - a) x (c - a).
  /// Collinear points give the normal zero.
  [[nodiscard]] static Plane through(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c);
  /// Through a point, perpendicular to a vector of any length.
  [[nodiscard]] static Plane at(const RationalPoint& point, const RationalPoint& normal);

  /// 1 for points in front, -1 behind, 0 in the plane. Exact.
  [[nodiscard]] int side(const RationalPoint& p) const;
  [[nodiscard]] Plane opposite() const;  ///< the same points; front and back change places

  friend bool operator==(const Plane&, const Plane&) = default;  ///< equal coefficients: multiples are not equal
};

}  // namespace strata
