#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "extensions/convex/point_cloud.h"

namespace strata::convex {

/// The corners of the hull of points in the plane of three of them, in order; no corner lies between others. O(n log
/// n). Source: Andrew 1979, the monotone chain.
[[nodiscard]] std::vector<std::uint32_t> polygon_hull(const PointCloud& cloud,
                                                      const std::array<std::uint32_t, 3>& triangle);

}  // namespace strata::convex
