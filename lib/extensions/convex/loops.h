#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace strata::convex {

/// Closed polygons of points by number, one after the other.
struct Loops {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;  ///< of every loop in `corners`

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t loop) const {
    const std::size_t begin = loop == 0 ? 0 : ends[loop - 1];
    return std::span(corners).subspan(begin, ends[loop] - begin);
  }
};

}  // namespace strata::convex
