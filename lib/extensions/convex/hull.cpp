#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

#include "core/csg/arena.h"
#include "extensions/convex/affine_span.h"
#include "extensions/convex/candidates.h"
#include "extensions/convex/facets.h"
#include "extensions/convex/point_cloud.h"
#include "extensions/convex/polygon_hull.h"
#include "extensions/convex/quickhull.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

/// The points as vertices of a polytope, in lexicographic order, -0 as 0. `number` maps each of them to its position
/// there.
Polytope with_vertices(const PointCloud& cloud, std::vector<std::uint32_t> points, std::vector<std::uint32_t>& number) {
  tbb::parallel_sort(points, [&](std::uint32_t p, std::uint32_t q) { return cloud.compare(p, q) == Sign::negative; });
  Polytope polytope;
  polytope.vertices.reserve(points.size());
  for (const std::uint32_t p : points) {
    const auto vertex = static_cast<std::uint32_t>(polytope.vertices.size());
    const auto& [x, y, z] = cloud.at(p);
    number[p] = vertex;
    polytope.vertices.push_back({x + 0.0, y + 0.0, z + 0.0});
    if (const RationalPoint* place = cloud.exact(p)) polytope.exact.push_back({vertex, *place});
  }
  return polytope;
}

/// The corners that occur in loops, each once.
std::vector<std::uint32_t> corners_of(const Loops& loops, std::uint32_t points) {
  std::vector<bool> used(points, false);
  std::vector<std::uint32_t> result;
  for (const std::uint32_t p : loops.corners) {
    if (!used[p]) result.push_back(p);
    used[p] = true;
  }
  return result;
}

/// Renumbers, and rotates every loop to its lowest corner.
void renumber(Loops& loops, const std::vector<std::uint32_t>& number) {
  tbb::parallel_for(std::size_t{0}, loops.size(), [&](std::size_t i) {
    const auto begin = loops.corners.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 0 : loops.ends[i - 1]);
    const auto end = loops.corners.begin() + static_cast<std::ptrdiff_t>(loops.ends[i]);
    std::transform(begin, end, begin, [&](std::uint32_t p) { return number[p]; });
    std::rotate(begin, std::min_element(begin, end), end);
  });
}

/// Lists of loops by first corner, each in lexicographic order.
std::vector<std::vector<std::uint32_t>> in_order(const Loops& loops, std::size_t vertices) {
  std::vector<std::uint32_t> begin(vertices + 1, 0), order(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) ++begin[loops[i][0]];
  std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), 0u);
  std::vector<std::uint32_t> at = begin;
  for (std::size_t i = 0; i < loops.size(); ++i) order[at[loops[i][0]]++] = static_cast<std::uint32_t>(i);
  std::vector<std::vector<std::uint32_t>> result(loops.size());
  tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t v) {
    std::sort(order.begin() + begin[v], order.begin() + begin[v + 1], [&](std::uint32_t i, std::uint32_t j) {
      return std::lexicographical_compare(loops[i].begin(), loops[i].end(), loops[j].begin(), loops[j].end());
    });
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i)
      result[i].assign(loops[order[i]].begin(), loops[order[i]].end());
  });
  return result;
}

Polytope polygon(const PointCloud& cloud, const std::vector<std::uint32_t>& span) {
  std::vector<std::uint32_t> loop = polygon_hull(cloud, {span[0], span[1], span[2]});
  std::vector<std::uint32_t> number(cloud.size());
  Polytope result = with_vertices(cloud, loop, number);
  for (std::uint32_t& p : loop) p = number[p];
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if (loop[1] > loop.back()) std::reverse(loop.begin() + 1, loop.end());
  result.facets.push_back(std::move(loop));
  return result;
}

Polytope solid(const PointCloud& cloud, const std::array<std::uint32_t, 4>& simplex, const Monitor& monitor) {
  Quickhull hull(cloud, simplex);
  std::vector<std::uint32_t> points(cloud.size());
  std::iota(points.begin(), points.end(), 0);
  hull.add(points, monitor);
  monitor.check();
  Loops loops = maximal_facets(hull, cloud.size());
  monitor.check();
  std::vector<std::uint32_t> number(cloud.size());
  Polytope result = with_vertices(cloud, corners_of(loops, cloud.size()), number);
  renumber(loops, number);
  monitor.check();
  result.facets = in_order(loops, result.vertices.size());
  return result;
}

/// The same, using only the points that may be extreme.
Polytope solid_of_many(const PointCloud& cloud, const std::array<std::uint32_t, 4>& simplex, const Monitor& monitor) {
  ExactMesh chosen;
  for (const std::uint32_t p : candidates(cloud, simplex, monitor)) {
    if (const RationalPoint* place = cloud.exact(p))
      chosen.exact.push_back({static_cast<std::uint32_t>(chosen.mesh.vertices.size()), *place});
    chosen.mesh.vertices.push_back(cloud.at(p));
  }
  return solid(PointCloud(chosen), {0, 1, 2, 3}, monitor);
}

Polytope hull_of(const PointCloud& cloud, const Monitor& monitor) {
  monitor.check();
  const std::vector<std::uint32_t> span = affine_span(cloud);
  std::vector<std::uint32_t> number(cloud.size());
  constexpr std::uint32_t many = 2000;
  Polytope result;
  if (span.size() == 4) {
    const std::array<std::uint32_t, 4> simplex{span[0], span[1], span[2], span[3]};
    result = cloud.size() < many ? solid(cloud, simplex, monitor) : solid_of_many(cloud, simplex, monitor);
  } else {
    result = span.size() == 3 ? polygon(cloud, span) : with_vertices(cloud, span, number);
  }
  result.dimension = static_cast<int>(span.size()) - 1;
  return result;
}

}  // namespace

Polytope convex_hull(ExactMeshView points, unsigned threads, const Monitor& monitor) {
  monitor.check();
  Polytope result;
  arena_for({.threads = threads}, points.mesh.vertices.size()).execute([&] {
    result = hull_of(PointCloud(points), monitor);
  });
  return result;
}

Polytope convex_hull(std::span<const Vertex> points, unsigned threads, const Monitor& monitor) {
  return convex_hull(ExactMeshView(MeshView(points, {}), {}), threads, monitor);
}

Polytope convex_hull(std::span<const Solid> solids, unsigned threads, const Monitor& monitor) {
  ExactMesh all;
  for (const Solid& s : solids) {
    monitor.check();
    const ExactMesh& mesh = s.exact_mesh();
    std::vector<bool> used(mesh.mesh.vertices.size(), false);
    for (const Triangle& t : mesh.mesh.triangles)
      for (const std::uint32_t v : t) used[v] = true;
    auto exact = mesh.exact.begin();
    for (std::uint32_t v = 0; v < used.size(); ++v) {
      while (exact != mesh.exact.end() && exact->vertex < v) ++exact;
      if (!used[v]) continue;
      if (exact != mesh.exact.end() && exact->vertex == v)
        all.exact.push_back({static_cast<std::uint32_t>(all.mesh.vertices.size()), exact->position});
      all.mesh.vertices.push_back(mesh.mesh.vertices[v]);
    }
  }
  return convex_hull(all, threads, monitor);
}

Solid solid_of(const Polytope& polytope) { return Solid::trusted(mesh_of(polytope)); }

}  // namespace strata::convex
