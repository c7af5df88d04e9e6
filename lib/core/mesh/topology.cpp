#include <algorithm>
#include <vector>

#include "core/kernel/disjoint_sets.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "strata/measure.h"

namespace strata {
namespace {

/// The triangles after identification of equal coordinates. Triangles that repeat a vertex are dropped.
std::vector<Triangle> identified_triangles(const ExactMesh& mesh) {
  const std::vector<std::uint32_t> first = equal_vertices(mesh);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.mesh.triangles.size());
  for (const Triangle& t : mesh.mesh.triangles) {
    const Triangle identified{first[t[0]], first[t[1]], first[t[2]]};
    if (!repeats_vertex(identified)) triangles.push_back(identified);
  }
  return triangles;
}

/// Groups the corners of triangles into fans: corners of one vertex whose triangles share a manifold edge there.
DisjointSets<std::size_t> corner_fans(const std::vector<EdgeUse>& table, std::size_t triangle_count) {
  DisjointSets<std::size_t> fans(3 * triangle_count);
  for_each_edge(table, [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const auto corner_at = [](const EdgeUse& use, bool at_low) {
      const std::size_t other = use.corner == 2 ? 0 : use.corner + 1;
      return 3 * std::size_t{use.triangle} + (use.forward == at_low ? use.corner : other);
    };
    for (const bool at_low : {true, false}) fans.unite(corner_at(uses[0], at_low), corner_at(uses[1], at_low));
  });
  return fans;
}

std::uint64_t vertices_with_several_fans(const std::vector<Triangle>& triangles, const std::vector<EdgeUse>& table,
                                         std::size_t vertex_count) {
  DisjointSets<std::size_t> fans = corner_fans(table, triangles.size());
  std::vector<std::uint8_t> count(vertex_count, 0);
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    std::uint8_t& fans_here = count[triangles[corner / 3][corner % 3]];
    if (fans.find(corner) == corner && fans_here < 2) ++fans_here;
  }
  return static_cast<std::uint64_t>(std::count(count.begin(), count.end(), 2));
}

}  // namespace

Topology topology(const ExactMesh& mesh) {
  const std::size_t vertex_count = mesh.mesh.vertices.size();
  const std::vector<Triangle> triangles = identified_triangles(mesh);
  const std::vector<EdgeUse> table = edge_table(triangles, vertex_count);
  Topology result;
  std::int64_t edges = 0;
  for_each_edge(table, [&](std::span<const EdgeUse> uses) {
    ++edges;
    result.non_manifold_edges += uses.size() > 2;
    result.open_edges += net_uses(uses) != 0;
  });
  DisjointSets<std::uint32_t> connected(vertex_count);
  std::vector<bool> used(vertex_count, false);
  for (const Triangle& t : triangles) {
    connected.unite(t[0], t[1]);
    connected.unite(t[0], t[2]);
    for (const std::uint32_t v : t) used[v] = true;
  }
  std::int64_t vertices = 0;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    vertices += used[v];
    result.components += used[v] && connected.find(v) == v;
  }
  result.euler = vertices - edges + static_cast<std::int64_t>(triangles.size());
  result.non_manifold_vertices = vertices_with_several_fans(triangles, table, vertex_count);
  return result;
}

}  // namespace strata
