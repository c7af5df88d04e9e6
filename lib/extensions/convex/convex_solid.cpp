#include "extensions/convex/convex_solid.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "core/kernel/disjoint_sets.h"
#include "extensions/convex/approximate_convex_set.h"
#include "extensions/convex/directions.h"

namespace strata::convex {
namespace {

using Loop = std::vector<std::uint32_t>;

bool is_connected(const Surface& surface) {
  DisjointSets<std::uint32_t> parts(surface.fans.size());
  for (const SurfaceEdge& e : surface.edges) parts.unite(e.fans[0], e.fans[1]);
  for (std::uint32_t i = 0; i < surface.fans.size(); ++i)
    if (parts.find(i) != 0) return false;
  return true;
}

/// The boundary loops of the facets that faces in one plane form: from every corner to the next.
std::vector<Loop> facets_of(const Surface& surface, const std::vector<signed char>& bend, const Monitor& monitor) {
  DisjointSets<std::uint32_t> planes(surface.faces.size());
  for (std::size_t e = 0; e < bend.size(); ++e)
    if (bend[e] == 0) planes.unite(surface.edges[e].left, surface.edges[e].right);
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> next;  // per plane
  for (std::size_t e = 0; e < bend.size(); ++e) {
    monitor.check();
    if (bend[e] == 0) continue;
    const SurfaceEdge& edge = surface.edges[e];
    next[planes.find(edge.left)][edge.from] = edge.to;
    next[planes.find(edge.right)][edge.to] = edge.from;
  }
  std::vector<Loop> loops;
  for (const auto& [plane, step] : next) {
    Loop loop;
    for (std::uint32_t v = step.begin()->first; loop.empty() || v != loop.front(); v = step.at(v)) loop.push_back(v);
    loops.push_back(std::move(loop));
  }
  return loops;
}

void drop_straight_corners(Loop& loop, const LatticePoints& lattice) {
  Loop kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& before = lattice.points[loop[(i + loop.size() - 1) % loop.size()]];
    const auto &here = lattice.points[loop[i]], &after = lattice.points[loop[(i + 1) % loop.size()]];
    const auto n = cross(minus(here, before), minus(after, here));
    if (n[0] != 0 || n[1] != 0 || n[2] != 0) kept.push_back(loop[i]);
  }
  loop = std::move(kept);
}

/// The polytope of the vertices that facets have, in lexicographic order.
Polytope in_order(const Surface& surface, std::vector<Loop> loops, const LatticePoints& lattice,
                  const Monitor& monitor) {
  std::vector<std::uint32_t> used;
  for (const Loop& loop : loops) used.insert(used.end(), loop.begin(), loop.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::sort(used.begin(), used.end(), [&](std::uint32_t v, std::uint32_t w) {
    monitor.check();
    return lattice.points[v] < lattice.points[w];
  });
  std::vector<std::uint32_t> number(lattice.points.size());
  Polytope result;
  result.dimension = 3;
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    number[used[i]] = i;
    result.vertices.push_back(surface.points.mesh.vertices[used[i]]);
  }
  std::vector<bool> is_used(number.size(), false);
  for (const std::uint32_t v : used) is_used[v] = true;
  for (const ExactVertex& e : surface.points.exact)
    if (e.vertex < is_used.size() && is_used[e.vertex]) result.exact.push_back({number[e.vertex], e.position});
  std::sort(result.exact.begin(), result.exact.end(),
            [](const ExactVertex& a, const ExactVertex& b) { return a.vertex < b.vertex; });
  for (Loop& loop : loops)
    for (std::uint32_t& v : loop) v = number[v];
  result.facets = std::move(loops);
  return result;
}

/// Doubles often prove that a solid is not convex at an edge.
bool is_surely_reflex(const Surface& surface, const SurfaceEdge& edge) {
  const auto& vertices = surface.points.mesh.vertices;
  const Loop& left = surface.faces[edge.left];
  return rounded_side(vertices[left[0]], vertices[left[1]], vertices[left[2]], vertices[edge.third[1]]) ==
         Sign::positive;
}

template <class N>
std::optional<Polytope> convex_solid_on(const Surface& surface, const LatticePoints& lattice, const Monitor& monitor) {
  const auto bend = directions_of<N>(surface, lattice, monitor).bend;
  if (std::any_of(bend.begin(), bend.end(), [](signed char b) { return b < 0; })) return std::nullopt;
  std::vector<Loop> loops = facets_of(surface, bend, monitor);
  for (Loop& loop : loops) {
    monitor.check();
    drop_straight_corners(loop, lattice);
  }
  return in_order(surface, std::move(loops), lattice, monitor);
}

}  // namespace

std::optional<Polytope> convex_solid(const Surface& surface, const Monitor& monitor) {
  const auto is_reflex = [&](const SurfaceEdge& edge) {
    monitor.check();
    return is_surely_reflex(surface, edge);
  };
  if (std::any_of(surface.edges.begin(), surface.edges.end(), is_reflex) || !is_connected(surface)) return std::nullopt;
  const LatticePoints lattice = lattice_points(surface.points, monitor);
  const int bits = 3 * lattice.bits + 7;
  if (bits <= 128) return convex_solid_on<__int128>(surface, lattice, monitor);
  if (bits <= 256) return convex_solid_on<WideInt<4>>(surface, lattice, monitor);
  return convex_solid_on<Integer>(surface, lattice, monitor);
}

}  // namespace strata::convex
