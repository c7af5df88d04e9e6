#include "core/kernel/rational_point.h"

#include <array>

#include "core/exact/lattice.h"

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

HPoint<Integer> homogeneous(const Vertex& p) { return homogeneous(std::span(&p, 1)).front(); }

std::vector<HPoint<Integer>> homogeneous(std::span<const Vertex> points) {
  Lattice lattice;
  lattice.add(1);
  for (const Vertex& p : points)
    for (const double x : p) lattice.add(x);
  const Integer w = Integer(1) << static_cast<std::size_t>(-lattice.unit());
  std::vector<HPoint<Integer>> result;
  result.reserve(points.size());
  for (const Vertex& p : points)
    result.push_back({lattice.integer<Integer>(p[0]), lattice.integer<Integer>(p[1]), lattice.integer<Integer>(p[2]), w,
                      lattice.unit() == 0});
  return result;
}

RationalPoint to_rational(const Vertex& p) { return {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}; }

RationalPoint rational(const HPoint<Integer>& p) {
  return {Rational(p.x, p.w), Rational(p.y, p.w), Rational(p.z, p.w)};
}

}  // namespace strata
