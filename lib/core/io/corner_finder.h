#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace strata::io {

/// Finds the corners of a polygon at which its triangles have their vertices; of several corners at a vertex, the
/// first.
class CornerFinder {
 public:
  /// A polygon of n corners; `vertex(i)` is that of corner i. O(n log n).
  template <class VertexOf>
  void start(std::size_t n, const VertexOf& vertex) {
    corners_.clear();
    for (std::size_t i = 0; i < n; ++i) corners_.emplace_back(vertex(i), i);
    std::sort(corners_.begin(), corners_.end());
  }
  /// Requires that the polygon has the vertex. O(log n).
  [[nodiscard]] std::size_t corner_at(std::uint32_t vertex) const {
    return std::lower_bound(corners_.begin(), corners_.end(), std::pair(vertex, std::size_t{0}))->second;
  }

 private:
  std::vector<std::pair<std::uint32_t, std::size_t>> corners_;
};

}  // namespace strata::io
