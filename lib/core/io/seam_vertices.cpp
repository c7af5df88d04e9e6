#include "core/io/seam_vertices.h"

#include <algorithm>
#include <variant>

namespace strata::io {
namespace {

bool are_equal(const std::vector<const Channel*>& channels, std::size_t a, std::size_t b) {
  return std::all_of(channels.begin(), channels.end(), [&](const Channel* c) {
    const std::size_t n = c->components;
    return std::visit([&](const auto& v) { return std::equal(&v[a * n], &v[a * n] + n, &v[b * n]); }, c->values);
  });
}

}  // namespace

SeamVertices divide_at_seams(const ObjectFaces& object, const std::vector<const Channel*>& channels) {
  constexpr std::uint32_t none = SeamVertices::none;
  const std::size_t count = object.vertices.size();
  SeamVertices result;
  // Versions of a vertex are chained: the first one of vertex v is v itself, further ones follow behind all vertices.
  std::vector<std::uint32_t> corner(count, none), next(count, none), vertex(count);
  for (std::size_t v = 0; v < count; ++v) vertex[v] = static_cast<std::uint32_t>(v);
  result.triangles = object.triangles;
  for (std::size_t f = 0; f < object.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t own = 3 * object.faces[f] + static_cast<std::uint32_t>(k);
      std::uint32_t at = object.triangles[f][k];
      while (corner[at] != none && !are_equal(channels, corner[at], own)) {
        if (next[at] == none) {
          next[at] = static_cast<std::uint32_t>(vertex.size());
          vertex.push_back(vertex[at]);
          corner.push_back(none);
          next.push_back(none);
        }
        at = next[at];
      }
      if (corner[at] == none) corner[at] = own;
      result.triangles[f][k] = at;
    }
  std::vector<std::uint32_t> number(vertex.size());
  for (std::size_t v = 0; v < count; ++v)
    for (std::uint32_t at = static_cast<std::uint32_t>(v); at != none; at = next[at]) {
      number[at] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(object.vertices[v]);
      result.corners.push_back(corner[at]);
    }
  for (Triangle& t : result.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  return result;
}

}  // namespace strata::io
