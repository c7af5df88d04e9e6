#pragma once
#include <optional>
#include <vector>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// The numbers between two ends, the ends with them; an end that is not there is infinite.
struct Interval {
  std::optional<Rational> lower, upper;
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The points p + t d.
template <int D>
struct ParametricLine {
  RationalVector<D> p, d;
};

/// The region of the line that intervals cover together, which may overlap; those without length do not count.
[[nodiscard]] Partition<1> partition_of(std::span<const Interval> intervals);

/// The components of a region of the line, in increasing order.
[[nodiscard]] std::vector<Interval> intervals_of(const Partition<1>& region);

/// Where a line is in the closed region: intervals of t, apart, in increasing order. Where it lies in the boundary it
/// is in; where it meets the region in a point only, the interval is this point. Requires d != 0. O(nodes that the line
/// meets * depth); the numbers are rationals of bounded size over the region's hyperplanes.
template <int D>
[[nodiscard]] std::vector<Interval> intersection(const Partition<D>& region, const ParametricLine<D>& line);

/// The same for the ray from t = 0 on.
template <int D>
[[nodiscard]] std::vector<Interval> ray_intersection(const Partition<D>& region, const ParametricLine<D>& ray);

}  // namespace strata::bsp
