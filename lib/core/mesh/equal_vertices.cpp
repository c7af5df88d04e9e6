#include "core/mesh/equal_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

#include "core/containers/distinct_hashes.h"
#include "core/containers/hash_index.h"
#include "core/containers/huge_pages.h"
#include "core/containers/point_hash.h"

namespace strata {
namespace {

using Bits = std::array<std::uint64_t, 3>;

Bits bits(const Vertex& v) {
  Bits result;
  for (int i = 0; i < 3; ++i) result[i] = v[i] == 0 ? 0 : std::bit_cast<std::uint64_t>(v[i]);  // -0 = 0
  return result;
}

using Numbers = std::vector<std::uint32_t>;

std::vector<std::uint64_t> hashes_of(std::span<const Vertex> vertices, const Monitor& monitor) {
  std::vector<std::uint64_t> hashes;
  resize_fresh(hashes, vertices.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 12), [&](const auto& range) {
    monitor.check();
    for (std::size_t v = range.begin(); v != range.end(); ++v) hashes[v] = hash_of(vertices[v]);
  });
  return hashes;
}

/// For each vertex the first of its equal ones; none if no two are equal. `equal` decides among vertices whose doubles
/// are the same.
template <class Equal>
std::optional<Numbers> first_equal(std::span<const Vertex> vertices, Equal equal, const Monitor& monitor = {}) {
  const std::vector<std::uint64_t> hashes = hashes_of(vertices, monitor);
  if (are_distinct(hashes, monitor)) return std::nullopt;
  ConcurrentHashIndex table(vertices.size());
  const auto for_each_vertex = [&](const auto& visit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 12), [&](const auto& range) {
      monitor.check();
      constexpr std::size_t at_once = 16;  // searches that wait for memory together
      for (std::size_t begin = range.begin(); begin < range.end(); begin += at_once) {
        const std::size_t end = std::min(begin + at_once, range.end());
        for (std::size_t n = begin; n != end; ++n) table.prefetch(hashes[n]);
        for (std::size_t n = begin; n != end; ++n) {
          const auto v = static_cast<std::uint32_t>(n);
          const Bits key = bits(vertices[v]);
          visit(v, hashes[n], [&](std::uint32_t there) { return bits(vertices[there]) == key && equal(there, v); });
        }
      }
    });
  };
  std::atomic<bool> has_equal = false;
  for_each_vertex([&](std::uint32_t v, std::uint64_t hash, const auto& is_equal) {
    if (table.add_lowest(hash, v, is_equal)) has_equal.store(true, std::memory_order_relaxed);
  });
  if (!has_equal) return std::nullopt;
  Numbers first;
  resize_fresh(first, vertices.size());
  for_each_vertex(
      [&](std::uint32_t v, std::uint64_t hash, const auto& is_equal) { first[v] = table.find(hash, is_equal); });
  return first;
}

std::optional<Numbers> first_equal_doubles(std::span<const Vertex> vertices, const Monitor& monitor) {
  return first_equal(
      vertices, [](std::uint32_t, std::uint32_t) { return true; }, monitor);
}

std::optional<Numbers> first_equal(ExactMeshView mesh, const Monitor& monitor) {
  if (mesh.exact.empty()) return first_equal_doubles(mesh.mesh.vertices, monitor);
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

std::optional<Numbers> first_equal(const NearestMesh& mesh) {
  if (mesh.rounded.empty()) return first_equal_doubles(mesh.mesh.vertices, {});
  std::vector<bool> is_rounded(mesh.mesh.vertices.size(), false);
  for (const std::uint32_t v : mesh.rounded) is_rounded[v] = true;
  return first_equal(mesh.mesh.vertices, [&](std::uint32_t a, std::uint32_t b) {
    return is_rounded[a] == is_rounded[b] && (a == b || !is_rounded[a] || mesh.are_equal(a, b));
  });
}

/// Each vertex by itself where no two are equal.
Numbers numbers_of(std::optional<Numbers> first, std::size_t vertices) {
  if (first) return std::move(*first);
  Numbers all;
  resize_fresh(all, vertices);
  tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t v) { all[v] = static_cast<std::uint32_t>(v); });
  return all;
}

std::vector<Triangle> with_vertices(std::span<const Triangle> triangles, const Numbers& first) {
  std::vector<Triangle> result;
  resize_fresh(result, triangles.size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t n) {
    const Triangle& t = triangles[n];
    result[n] = {first[t[0]], first[t[1]], first[t[2]]};
  });
  return result;
}

}  // namespace

std::vector<std::uint32_t> equal_vertices(std::span<const Vertex> vertices, const Monitor& monitor) {
  return numbers_of(first_equal_doubles(vertices, monitor), vertices.size());
}

std::vector<std::uint32_t> equal_vertices(ExactMeshView mesh, const Monitor& monitor) {
  return numbers_of(first_equal(mesh, monitor), mesh.mesh.vertices.size());
}

std::vector<Triangle> on_first_vertices(ExactMeshView mesh, const Monitor& monitor) {
  const std::optional<Numbers> first = first_equal(mesh, monitor);
  return first ? with_vertices(mesh.mesh.triangles, *first)
               : std::vector<Triangle>(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end());
}

OnFirstVertices::OnFirstVertices(std::span<const Triangle> triangles, const std::optional<Numbers>& first) {
  if (first) changed_ = with_vertices(triangles, *first);
  triangles_ = first ? std::span<const Triangle>(changed_) : triangles;
}

OnFirstVertices::OnFirstVertices(ExactMeshView mesh, const Monitor& monitor)
    : OnFirstVertices(mesh.mesh.triangles, first_equal(mesh, monitor)) {}

OnFirstVertices::OnFirstVertices(const NearestMesh& mesh) : OnFirstVertices(mesh.mesh.triangles, first_equal(mesh)) {}

NearestMesh NearestMesh::of(const ExactMesh& exact) {
  NearestMesh nearest{
      exact.mesh, {}, [&exact](std::uint32_t a, std::uint32_t b) { return exact.position(a) == exact.position(b); }};
  for (const ExactVertex& e : exact.exact) nearest.rounded.push_back(e.vertex);
  return nearest;
}

}  // namespace strata
