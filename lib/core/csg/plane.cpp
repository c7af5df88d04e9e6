#include "strata/plane.h"

namespace strata {

Plane Plane::through(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  RationalPoint normal;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    normal[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
  }
  return at(a, normal);
}

Plane Plane::at(const RationalPoint& p, const RationalPoint& n) { return {n, n[0] * p[0] + n[1] * p[1] + n[2] * p[2]}; }

int Plane::side(const RationalPoint& p) const {
  return Rational(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] - offset).sign();
}

Plane Plane::opposite() const { return {{-normal[0], -normal[1], -normal[2]}, -offset}; }

}  // namespace strata
