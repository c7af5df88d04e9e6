#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "strata/mesh.h"

namespace strata {

/// The maximum norm, in doubles.
inline double size(const Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// In the maximum norm, rounded.
inline double distance(const Vertex& p, const Vertex& q) { return size({p[0] - q[0], p[1] - q[1], p[2] - q[2]}); }

/// At least the rounding error of a coordinate rounded to the nearest double.
inline double half_unit(const Vertex& v) {
  const double largest = size(v);
  const double next = std::nextafter(largest, std::numeric_limits<double>::infinity());
  const double unit = std::isfinite(next) ? next - largest : largest - std::nextafter(largest, 0.0);
  return std::max(unit / 2, std::numeric_limits<double>::denorm_min());
}

}  // namespace strata
