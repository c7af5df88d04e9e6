#include "core/mesh/vertex_stars.h"

#include "core/exact/pace.h"
#include "core/mesh/edge_table.h"

namespace strata {

// A counting sort: while it places triangles, `begin_` is one place ahead.
VertexStars::VertexStars(std::span<const Triangle> triangles, std::size_t vertex_count, const Monitor& monitor)
    : begin_(vertex_count + 2, 0) {
  Pace pace(monitor);
  const auto for_each_corner = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      pace.step();
      if (!repeats_vertex(triangles[t]))
        for (const std::uint32_t v : triangles[t]) visit(v, t);
    }
  };
  for_each_corner([&](std::uint32_t v, std::uint32_t) { ++begin_[v + 2]; });
  for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  triangles_.resize(begin_.back());
  for_each_corner([&](std::uint32_t v, std::uint32_t t) { triangles_[begin_[v + 1]++] = t; });
  begin_.pop_back();
}

}  // namespace strata
