#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "strata/io/writers.h"

namespace strata::io {
namespace {

/// The first item that is not as it must be, or the end. In parallel as long as all are.
template <class Item, class IsGood>
auto find_bad(std::span<const Item> items, const IsGood& is_good) {
  std::atomic<bool> all = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, items.size(), 1 << 14), [&](const auto& range) {
    const auto part = items.subspan(range.begin(), range.size());
    if (!std::all_of(part.begin(), part.end(), is_good)) all = false;
  });
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

}  // namespace strata::io
