#pragma once
#include <algorithm>

#include "core/exact/sign.h"
#include "extensions/planar/places.h"

namespace strata::planar {

/// The decisions about points and lines of the plane. Each is the sign of an exact expression for all finite input:
/// doubles with bounds first, then integers of fixed width, then unbounded ones; theory.md, section 2.

namespace closer {  // tiers after the first filter
[[nodiscard]] Sign side(const Places& places, std::uint32_t point, std::uint32_t line);
}
namespace exact {
[[nodiscard]] Sign side(const Places& places, std::uint32_t point, std::uint32_t line);
[[nodiscard]] Sign cross(const Places& places, std::uint32_t line, std::uint32_t other);
[[nodiscard]] Sign compare(const Places& places, std::uint32_t p, std::uint32_t q, std::size_t axis);
}  // namespace exact

/// Side of a point relative to a directed line: positive to the left, zero on it.
[[nodiscard]] inline Sign side(const Places& places, std::uint32_t point, std::uint32_t line) {
  const auto [a, b] = places.lines[line];
  if (std::max({point, a, b}) < places.doubles()) {
    const int orientation = filtered_orientation(places.place[a], places.place[b], places.place[point]);
    if (orientation != 0) return static_cast<Sign>(orientation);
  }
  return closer::side(places, point, line);
}

/// Orientation of the directions of two lines: positive when `other` points to the left, zero when parallel.
[[nodiscard]] Sign cross(const Places& places, std::uint32_t line, std::uint32_t other);

/// Order of two points by one coordinate.
[[nodiscard]] inline Sign compare(const Places& places, std::uint32_t p, std::uint32_t q, std::size_t axis) {
  const double d = places.place[p][axis] - places.place[q][axis];
  if (places.is_double(p) && places.is_double(q)) return sign_of(d);  // gradual underflow: zero only when equal
  const std::optional<Sign> sign = (bounded(places, p, axis) - bounded(places, q, axis)).sign();
  return sign ? *sign : exact::compare(places, p, q, axis);
}

/// Order by x, then by y.
[[nodiscard]] inline Sign compare_xy(const Places& places, std::uint32_t p, std::uint32_t q) {
  if (p == q) return Sign::zero;
  const Sign by_x = compare(places, p, q, 0);
  return by_x != Sign::zero ? by_x : compare(places, p, q, 1);
}

/// Order along a line, of two points that lie on it: negative when p comes first.
[[nodiscard]] inline Sign compare_along(const Places& places, std::uint32_t line, std::uint32_t p, std::uint32_t q) {
  if (p == q) return Sign::zero;
  const PlanePoint& a = places.place[places.lines[line].from];
  const PlanePoint& b = places.place[places.lines[line].to];
  const std::size_t near = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1;
  for (const std::size_t axis : {near, 1 - near}) {
    const Sign direction = compare(places, places.lines[line].to, places.lines[line].from, axis);
    if (direction == Sign::zero) continue;
    return direction * compare(places, p, q, axis);
  }
  return Sign::zero;
}

/// Positive for a direction to the right or straight up, in (-90, 90] degrees; negative for the others.
[[nodiscard]] inline Sign heading(const Places& places, std::uint32_t line) {
  return compare_xy(places, places.lines[line].to, places.lines[line].from);
}

}  // namespace strata::planar
