#include "core/io/seam_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <utility>
#include <variant>

#include "core/containers/huge_pages.h"

namespace strata::io {
namespace {

/// True where two corners have the same values; NaN is none, but a corner equals itself.
bool have_equal_values(const std::vector<const Channel*>& channels, std::size_t a, std::size_t b) {
  return a == b || std::all_of(channels.begin(), channels.end(), [&](const Channel* c) {
           const std::size_t n = c->components;
           return std::visit([&](const auto& v) { return std::equal(&v[a * n], &v[a * n] + n, &v[b * n]); }, c->values);
         });
}

/// The number of a corner of a face of the object, in the mesh.
std::uint32_t corner_of(const ObjectFaces& object, std::size_t f, std::size_t k) {
  return 3 * object.faces[f] + static_cast<std::uint32_t>(k);
}

/// Per vertex its first corner, or none. Not in parallel: atomic minima at far places take four times as long.
std::vector<std::uint32_t> first_corners(const ObjectFaces& object) {
  std::vector<std::uint32_t> first;
  resize_fresh(first, object.vertices.size(), SeamVertices::none);
  for (std::size_t f = 0; f < object.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& corner = first[object.triangles[f][k]];
      if (corner == SeamVertices::none) corner = corner_of(object, f, k);
    }
  return first;
}

/// Per vertex, 1 where some corners differ from the first one. In parallel.
std::vector<std::uint8_t> vertices_at_seams(const ObjectFaces& object, const std::vector<const Channel*>& channels,
                                            const std::vector<std::uint32_t>& first) {
  std::vector<std::uint8_t> is_at_seam(object.vertices.size());
  if (channels.empty()) return is_at_seam;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, object.triangles.size(), 1 << 13), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = object.triangles[f][k];
        if (!have_equal_values(channels, first[v], corner_of(object, f, k)))
          std::atomic_ref<std::uint8_t>(is_at_seam[v]).store(1, std::memory_order_relaxed);
      }
  });
  return is_at_seam;
}

}  // namespace

SeamVertices divide_at_seams(ObjectFaces& object, const std::vector<const Channel*>& channels) {
  constexpr std::uint32_t none = SeamVertices::none;
  std::vector<std::uint32_t> corner = first_corners(object);
  const std::vector<std::uint8_t> is_at_seam = vertices_at_seams(object, channels, corner);
  if (std::find(is_at_seam.begin(), is_at_seam.end(), 1) == is_at_seam.end()) {
    return {std::move(object.vertices), std::move(corner), std::move(object.triangles)};
  }
  const std::vector<std::uint32_t> vertices = std::move(object.vertices);
  SeamVertices result;
  result.triangles = std::move(object.triangles);
  // Versions of a vertex are chained: the first one of vertex v is v itself, further ones follow behind all vertices.
  std::vector<std::uint32_t> next(vertices.size(), none);
  for (std::size_t f = 0; f < result.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t at = result.triangles[f][k];
      if (is_at_seam[at] == 0) continue;
      const std::uint32_t own = corner_of(object, f, k);
      while (!have_equal_values(channels, corner[at], own)) {
        if (next[at] == none) {
          next[at] = static_cast<std::uint32_t>(corner.size());
          corner.push_back(own);
          next.push_back(none);
        }
        at = next[at];
      }
      result.triangles[f][k] = at;
    }
  std::vector<std::uint32_t> number(corner.size());
  result.vertices.reserve(corner.size());
  result.corners.reserve(corner.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::uint32_t at = static_cast<std::uint32_t>(v); at != none; at = next[at]) {
      number[at] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(vertices[v]);
      result.corners.push_back(corner[at]);
    }
  for (Triangle& t : result.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  return result;
}

}  // namespace strata::io
