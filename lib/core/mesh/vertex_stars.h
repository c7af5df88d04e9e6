#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// The triangles around each vertex, by increasing number. Triangles that repeat a vertex are left out. Indices must be
/// below vertex_count. O(n).
class VertexStars {
 public:
  VertexStars(std::span<const Triangle> triangles, std::size_t vertex_count, const Monitor& monitor = {});

  [[nodiscard]] std::size_t vertex_count() const { return begin_.size() - 1; }
  [[nodiscard]] std::size_t triangle_count() const { return triangles_.size() / 3; }  ///< without those left out
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t vertex) const {
    return std::span(triangles_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::size_t> begin_;  ///< in `triangles_`, per vertex
  std::vector<std::uint32_t> triangles_;
};

}  // namespace strata
