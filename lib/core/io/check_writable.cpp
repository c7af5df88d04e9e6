#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "core/io/holds_for_all.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

/// The first invalid item, or the end. In parallel while all are valid.
template <class Item, class IsGood>
auto find_bad(std::span<const Item> items, const IsGood& is_good) {
  const bool all = holds_for_all(items.size(), [&](std::size_t i) { return is_good(items[i]); });
  return all ? items.end() : std::find_if_not(items.begin(), items.end(), is_good);
}

}  // namespace

void check_writable(MeshView mesh, const std::string& name) {
  const auto [vertices, triangles] = mesh;
  const auto vertex = find_bad(
      vertices, [](const Vertex& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
  if (vertex != vertices.end())
    throw IoError(name, {}, "cannot write: vertex " + std::to_string(vertex - vertices.begin()) + " is not finite");
  const auto is_in_range = [&](std::uint32_t v) { return v < mesh.vertices.size(); };
  const auto triangle = find_bad(
      triangles, [&](const Triangle& t) { return is_in_range(t[0]) && is_in_range(t[1]) && is_in_range(t[2]); });
  if (triangle == triangles.end()) return;
  throw IoError(name, {},
                "cannot write: triangle " + std::to_string(triangle - triangles.begin()) + " uses vertex " +
                    std::to_string(*std::find_if_not(triangle->begin(), triangle->end(), is_in_range)) + " of " +
                    std::to_string(vertices.size()));
}

void check_writable(std::span<const ExactVertex> exact, std::size_t vertex_count, const std::string& name) {
  const ExactVertex* before = nullptr;
  for (const ExactVertex& e : exact) {
    const std::string which = "cannot write: the exact place of vertex " + std::to_string(e.vertex);
    if (e.vertex >= vertex_count) throw IoError(name, {}, which + " of " + std::to_string(vertex_count));
    if (before != nullptr && before->vertex >= e.vertex) throw IoError(name, {}, which + " is not in order");
    for (const Rational& x : e.position)
      if (!std::isfinite(to_nearest_double(x))) throw IoError(name, {}, which + " is beyond the range of doubles");
    before = &e;
  }
}

}  // namespace strata::io
