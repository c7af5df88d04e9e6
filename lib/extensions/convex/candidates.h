#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "extensions/convex/point_cloud.h"
#include "strata/monitor.h"

namespace strata::convex {

/// Points that may be extreme, the four of a simplex first: all but those that are certainly in the hull of a few far
/// ones. The others are in an order in which neighbours in space are neighbours in the list. This affects speed only.
/// O(n). Throws Cancelled. Source: Akl and Toussaint 1978 for the hull of a few.
[[nodiscard]] std::vector<std::uint32_t> candidates(const PointCloud& cloud,
                                                    const std::array<std::uint32_t, 4>& simplex,
                                                    const Monitor& monitor);

}  // namespace strata::convex
