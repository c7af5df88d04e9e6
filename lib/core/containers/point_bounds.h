#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/kernel/box.h"

namespace strata {

/// The box of those points that are finite. O(n), in parallel.
[[nodiscard]] inline Box bounds_of_finite(std::span<const std::array<double, 3>> points) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, points.size(), 1 << 14), Box(),
      [&](const tbb::blocked_range<std::size_t>& range, Box box) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          if (std::isfinite(points[i][0]) && std::isfinite(points[i][1]) && std::isfinite(points[i][2]))
            box.include(points[i]);
        return box;
      },
      [](Box a, const Box& b) {
        a.include(b);
        return a;
      });
}

}  // namespace strata
