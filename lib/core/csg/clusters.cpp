#include "core/csg/clusters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/containers/box_sweep.h"

namespace strata {
namespace {

using Index = std::uint32_t;

/// The vertices of the faces of some pairs, by increasing number.
std::vector<Index> vertices_of(const Mesh& mesh, std::span<const SelfIntersection> pairs) {
  std::vector<Index> vertices;
  for (const SelfIntersection& p : pairs)
    for (const Index f : {p.face, p.other})
      vertices.insert(vertices.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double size(const Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// Pairs of vertices that may be near, the lower one first, in order.
std::vector<std::pair<Index, Index>> near_pairs(const Mesh& mesh, const std::vector<Index>& vertices,
                                                const GridRounding& grid, double reach) {
  std::vector<Box> boxes(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& p = mesh.vertices[vertices[i]];
    const double half = reach * grid.unit_at(size(p)) / 2;
    boxes[i].include(Vertex{p[0] - half, p[1] - half, p[2] - half});
    boxes[i].include(Vertex{p[0] + half, p[1] + half, p[2] + half});
  }
  std::vector<std::pair<Index, Index>> near;
  for_each_overlapping_pair(
      boxes, [&](Index a, Index b) { near.emplace_back(vertices[std::min(a, b)], vertices[std::max(a, b)]); });
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace

std::vector<double> join_near_vertices(Mesh& mesh, std::span<const SelfIntersection> pairs, const GridRounding& grid,
                                       double reach) {
  enum class State : std::uint8_t { free, stays, goes };
  std::vector<State> state(mesh.vertices.size(), State::free);
  std::vector<Index> becomes(mesh.vertices.size());
  std::iota(becomes.begin(), becomes.end(), 0U);
  std::vector<double> way(mesh.vertices.size(), 0);
  for (const auto& [stays, goes] : near_pairs(mesh, vertices_of(mesh, pairs), grid, reach)) {
    if (state[stays] == State::goes || state[goes] != State::free) continue;
    const Vertex &p = mesh.vertices[stays], &q = mesh.vertices[goes];
    const double length = size({p[0] - q[0], p[1] - q[1], p[2] - q[2]});
    if (length > reach * grid.unit_at(size(p))) continue;
    state[stays] = State::stays;
    state[goes] = State::goes;
    becomes[goes] = stays;
    way[goes] = length;
  }
  std::vector<double> moved;
  moved.reserve(mesh.triangles.size());
  for (Triangle& t : mesh.triangles) {
    moved.push_back(std::max({way[t[0]], way[t[1]], way[t[2]]}));
    for (Index& v : t) v = becomes[v];
  }
  return moved;
}

}  // namespace strata
