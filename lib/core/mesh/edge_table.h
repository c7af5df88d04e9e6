#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/pace.h"
#include "strata/mesh.h"

namespace strata {

/// One side of one triangle, as a use of the undirected edge (low, high).
struct EdgeUse {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  std::uint8_t corner;  ///< the side runs from this corner of the triangle to the next
  bool forward;         ///< the side runs from low to high

  [[nodiscard]] bool same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles, sorted by undirected edge, then by triangle. Triangles that repeat a vertex are left
/// out. Indices must be below vertex_count. O(n log d) for vertices of degree d.
[[nodiscard]] std::vector<EdgeUse> edge_table(std::span<const Triangle> triangles, std::size_t vertex_count,
                                              const Monitor& monitor = {});

/// Calls visit(std::span<const EdgeUse>) once per undirected edge, in order.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> table, Visit&& visit, const Monitor& monitor = {}) {
  Pace pace(monitor);
  for (std::size_t begin = 0, end = 0; begin < table.size(); begin = end) {
    pace.step();
    while (end < table.size() && table[end].same_edge(table[begin])) ++end;
    visit(table.subspan(begin, end - begin));
  }
}

/// Uses from low to high minus uses from high to low: zero when the edge is closed.
[[nodiscard]] inline std::int64_t net_uses(std::span<const EdgeUse> uses) {
  std::int64_t net = 0;
  for (const EdgeUse& use : uses) net += use.forward ? 1 : -1;
  return net;
}

[[nodiscard]] inline bool repeats_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace strata
