#include "extensions/planar/monotone_chains.h"

namespace strata::planar {
namespace {

/// Side of a point relative to the line from a to b.
Sign side_of(const Places& places, std::uint32_t point, const PlanePoint& a, const PlanePoint& b) {
  if (places.is_double(point)) return orientation(a, b, places.place[point]);
  const Bounded x = bounded(places, point, 0) - a[0], y = bounded(places, point, 1) - a[1];
  const Bounded u = Bounded(b[0]) - Bounded(a[0]), v = Bounded(b[1]) - Bounded(a[1]);
  if (const std::optional<Sign> sign = (u * y - v * x).sign()) return *sign;
  Places three;
  three.add(a);
  three.add(b);
  three.add(exact_position(places, point));
  three.lines.push_back({0, 1});
  return side(three, 2, 0);
}

Sign compare(const Places& places, std::uint32_t point, const PlanePoint& q, std::size_t axis) {
  if (places.is_double(point)) return sign_of(places.place[point][axis] - q[axis]);
  if (const std::optional<Sign> sign = (bounded(places, point, axis) - Bounded(q[axis])).sign()) return *sign;
  return sign_of(Rational(exact_position(places, point)[axis] - to_rational(q[axis])));
}

bool is_before(const Places& places, std::uint32_t point, const PlanePoint& q) {
  const Sign by_x = compare(places, point, q, 0);
  return (by_x != Sign::zero ? by_x : compare(places, point, q, 1)) == Sign::negative;
}

}  // namespace

Sign closer::orientation(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
  if (const std::optional<Sign> sign = orientation_by_differences(p, q, r)) return *sign;
  Places three;
  for (const PlanePoint& point : {p, q, r}) three.add(point);
  three.lines.push_back({0, 1});
  return planar::side(three, 2, 0);
}

Sign MonotoneChains::side_of_chain(const Places& places, std::uint32_t point, std::uint32_t segment) const {
  const auto [from, to] = places.lines[segment];
  if (point == from || point == to) return Sign::zero;
  const MonotoneChain& s = of(segment);
  const bool is_forward = compare_xy(places, from, to) == Sign::negative;
  // Binary search for the first vertex, along the chain, after the point in the order.
  std::uint32_t low = s.first, high = s.last + 1;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (is_before(places, point, s.point(middle)) == is_forward) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  if (low > s.first && low <= s.last) return side_of(places, point, s.point(low - 1), s.point(low));
  // At the chain's height, but to the left of all of it, or to the right.
  const bool is_left = (low == s.first) == is_forward;
  const bool is_upward = compare(places, to, s.point(s.first), 1) == Sign::positive;
  return is_left == is_upward ? Sign::positive : Sign::negative;
}

}  // namespace strata::planar
