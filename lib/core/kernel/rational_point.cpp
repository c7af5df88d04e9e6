#include "core/kernel/rational_point.h"

#include <array>

namespace strata {

HPoint<Integer> homogeneous(const RationalPoint& p) {
  Integer w = denominator(p[0]);
  for (std::size_t i = 1; i < 3; ++i)
    if (denominator(p[i]) != w) w = lcm(w, denominator(p[i]));
  std::array<Integer, 3> n;
  for (std::size_t i = 0; i < 3; ++i)
    n[i] = denominator(p[i]) == w ? numerator(p[i]) : Integer(numerator(p[i]) * (w / denominator(p[i])));
  return {n[0], n[1], n[2], w, w == 1};
}

RationalPoint rational(const HPoint<Integer>& p) {
  return {Rational(p.x, p.w), Rational(p.y, p.w), Rational(p.z, p.w)};
}

}  // namespace strata
