#include "core/mesh/equal_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <bit>

#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"

namespace strata {
namespace {

using Bits = std::array<std::uint64_t, 3>;

Bits bits(const Vertex& v) {
  Bits result;
  for (int i = 0; i < 3; ++i) result[i] = v[i] == 0 ? 0 : std::bit_cast<std::uint64_t>(v[i]);  // -0 = 0
  return result;
}

/// `equal` decides among vertices whose doubles are the same.
template <class Equal>
std::vector<std::uint32_t> first_equal(std::span<const Vertex> vertices, Equal equal, const Monitor& monitor = {}) {
  ConcurrentHashIndex table(vertices.size());
  std::vector<std::uint32_t> first(vertices.size());
  const auto for_each_vertex = [&](const auto& visit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 12), [&](const auto& range) {
      monitor.check();
      for (std::size_t n = range.begin(); n != range.end(); ++n) {
        const auto v = static_cast<std::uint32_t>(n);
        const Bits key = bits(vertices[v]);
        visit(v, [&](std::uint32_t there) { return bits(vertices[there]) == key && equal(there, v); });
      }
    });
  };
  std::atomic<bool> has_equal = false;
  for_each_vertex([&](std::uint32_t v, const auto& is_equal) {
    first[v] = v;
    if (table.add_lowest(hash_of(vertices[v]), v, is_equal)) has_equal.store(true, std::memory_order_relaxed);
  });
  if (!has_equal) return first;
  for_each_vertex(
      [&](std::uint32_t v, const auto& is_equal) { first[v] = table.find(hash_of(vertices[v]), is_equal); });
  return first;
}

std::vector<Triangle> with_vertices(std::span<const Triangle> triangles, const std::vector<std::uint32_t>& first) {
  std::vector<Triangle> result(triangles.begin(), triangles.end());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t n) {
    for (std::uint32_t& v : result[n]) v = first[v];
  });
  return result;
}

}  // namespace

std::vector<std::uint32_t> equal_vertices(std::span<const Vertex> vertices, const Monitor& monitor) {
  return first_equal(
      vertices, [](std::uint32_t, std::uint32_t) { return true; }, monitor);
}

std::vector<std::uint32_t> equal_vertices(ExactMeshView mesh, const Monitor& monitor) {
  if (mesh.exact.empty()) return equal_vertices(mesh.mesh.vertices, monitor);
  std::vector<const RationalPoint*> exact(mesh.mesh.vertices.size(), nullptr);
  for (const ExactVertex& e : mesh.exact) exact[e.vertex] = &e.position;
  return first_equal(
      mesh.mesh.vertices,
      [&](std::uint32_t a, std::uint32_t b) {
        if (!exact[a] && !exact[b]) return true;
        return exact[a] && exact[b] ? *exact[a] == *exact[b] : mesh.position(a) == mesh.position(b);
      },
      monitor);
}

std::vector<std::uint32_t> equal_vertices(const NearestMesh& mesh) {
  if (mesh.rounded.empty()) return equal_vertices(mesh.mesh.vertices);
  std::vector<bool> is_rounded(mesh.mesh.vertices.size(), false);
  for (const std::uint32_t v : mesh.rounded) is_rounded[v] = true;
  return first_equal(mesh.mesh.vertices, [&](std::uint32_t a, std::uint32_t b) {
    return is_rounded[a] == is_rounded[b] && (a == b || !is_rounded[a] || mesh.position(a) == mesh.position(b));
  });
}

std::vector<Triangle> on_first_vertices(ExactMeshView mesh, const Monitor& monitor) {
  return with_vertices(mesh.mesh.triangles, equal_vertices(mesh, monitor));
}

std::vector<Triangle> on_first_vertices(const NearestMesh& mesh) {
  return with_vertices(mesh.mesh.triangles, equal_vertices(mesh));
}

NearestMesh NearestMesh::of(const ExactMesh& exact) {
  NearestMesh nearest{exact.mesh, {}, [&exact](std::uint32_t vertex) { return exact.position(vertex); }};
  for (const ExactVertex& e : exact.exact) nearest.rounded.push_back(e.vertex);
  return nearest;
}

}  // namespace strata
