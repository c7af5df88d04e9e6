#include "core/mesh/edge_table.h"

#include <algorithm>
#include <tuple>

namespace strata {

std::vector<EdgeUse> edge_table(std::span<const Triangle> triangles, std::size_t vertex_count, const Monitor& monitor) {
  // Counting sort by the lower vertex, then a small sort for each of them.
  std::vector<std::size_t> begin(vertex_count + 1, 0);
  Pace pace(monitor);
  const auto for_each_side = [&](auto visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      pace.step();
      if (repeats_vertex(triangles[t])) continue;
      for (std::uint8_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t from = triangles[t][corner];
        const std::uint32_t to = triangles[t][corner == 2 ? 0 : corner + 1];
        visit(EdgeUse{std::min(from, to), std::max(from, to), t, corner, from < to});
      }
    }
  };
  for_each_side([&](const EdgeUse& use) { ++begin[use.low + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
  std::vector<EdgeUse> table(begin[vertex_count]);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_side([&](const EdgeUse& use) { table[next[use.low]++] = use; });
  for (std::size_t v = 0; v < vertex_count; ++v) {
    pace.step();
    std::sort(table.begin() + begin[v], table.begin() + begin[v + 1], [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle, a.corner) < std::tie(b.high, b.triangle, b.corner);
    });
  }
  return table;
}

}  // namespace strata
