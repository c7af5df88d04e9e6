#pragma once
#include <cstdint>
#include <vector>

#include "extensions/convex/point_cloud.h"

namespace strata::convex {

/// Points of a cloud whose affine span contains all others, as few as possible: none, one, two different, three not
/// collinear or four not coplanar. They are far apart, judged in doubles. Their number minus one is the dimension. Two
/// are the ends of the segment. O(n).
[[nodiscard]] std::vector<std::uint32_t> affine_span(const PointCloud& cloud);

}  // namespace strata::convex
