#include "core/mesh/gathered_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/containers/huge_pages.h"
#include "core/containers/z_cells.h"

namespace strata {
namespace {

constexpr std::size_t grain = 1 << 14;

template <class Visit>
void for_each_below(std::size_t count, const Monitor& monitor, const Visit& visit) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    monitor.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) visit(i);
  });
}

Box bounds_of(std::span<const Vertex> points) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, points.size(), grain), Box(),
      [&](const auto& range, Box box) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) box.include(points[i]);
        return box;
      },
      [](Box a, const Box& b) {
        a.include(b);
        return a;
      });
}

/// Vertices by number along the curve; as they are where all are in one cell.
FreshArray<PlacedItem> placed_vertices(std::span<const Vertex> points, const Monitor& monitor) {
  const ZCells cells(bounds_of(points));
  FreshArray<PlacedItem> placed(points.size());
  for_each_below(points.size(), monitor, [&](std::size_t i) {
    placed[i] = {cells.are_useful() ? cells.code(points[i]) : 0, static_cast<std::uint32_t>(i)};
  });
  sort_by_code(placed);
  return placed;
}

}  // namespace

bool is_scattered(MeshView mesh) {
  constexpr std::size_t least_vertices = 100'000, samples = 1000;
  constexpr std::uint32_t far = 20'000;  // vertices: half a megabyte
  if (mesh.vertices.size() < least_vertices || mesh.triangles.size() < least_vertices) return false;
  const std::size_t step = (mesh.triangles.size() - 1) / samples;
  std::size_t jumps = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const Triangle &t = mesh.triangles[k * step], &next = mesh.triangles[k * step + 1];
    const auto [low, high] = std::minmax({t[0], t[1], t[2], next[0], next[1], next[2]});
    jumps += high - low > far ? 1 : 0;
  }
  return jumps > samples / 4;
}

Mesh gathered(MeshView mesh, const Monitor& monitor) {
  Mesh result;
  FreshArray<std::uint32_t> number(mesh.vertices.size());
  resize_fresh(result.vertices, mesh.vertices.size());
  {
    const FreshArray<PlacedItem> placed = placed_vertices(mesh.vertices, monitor);
    for_each_below(placed.size(), monitor, [&](std::size_t i) {
      result.vertices[i] = mesh.vertices[placed[i].item];
      number[placed[i].item] = static_cast<std::uint32_t>(i);
    });
  }
  const int shift = std::max(0, static_cast<int>(std::bit_width(mesh.vertices.size())) - 30);
  FreshArray<Triangle> renumbered(mesh.triangles.size());
  FreshArray<PlacedItem> placed(mesh.triangles.size());
  for_each_below(placed.size(), monitor, [&](std::size_t f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Triangle t{number[a], number[b], number[c]};
    renumbered[f] = t;
    placed[f] = {std::min({t[0], t[1], t[2]}) >> shift, static_cast<std::uint32_t>(f)};
  });
  sort_by_code(placed);
  resize_fresh(result.triangles, placed.size());
  for_each_below(placed.size(), monitor, [&](std::size_t i) { result.triangles[i] = renumbered[placed[i].item]; });
  return result;
}

}  // namespace strata
