#include <algorithm>

#include "strata/planar.h"

namespace strata::planar {

bool CanonicalDecomposition::is_manifold() const {
  return std::all_of(degree.begin(), degree.end(), [](std::uint32_t d) { return d == 2; });
}

CanonicalDecomposition canonical_decomposition(const Region& region, std::uint32_t polygon) {
  const Region alone = polygon_of(region, polygon);  // without the vertices that exist because of other polygons only
  CanonicalDecomposition d;
  const auto number = [&](std::uint32_t v) {
    const RationalPlacement p = exact_position(alone.loops.places, v);
    return static_cast<std::uint32_t>(std::lower_bound(d.vertices.begin(), d.vertices.end(), p) - d.vertices.begin());
  };
  for (const std::uint32_t v : alone.loops.vertices) d.vertices.push_back(exact_position(alone.loops.places, v));
  std::sort(d.vertices.begin(), d.vertices.end());
  d.vertices.erase(std::unique(d.vertices.begin(), d.vertices.end()), d.vertices.end());
  d.degree.assign(d.vertices.size(), 0);
  for (std::uint32_t l = 0; l < alone.loops.size(); ++l) {
    const auto loop = alone.loops.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      d.edges.push_back({number(loop[i]), number(loop[i + 1 < loop.size() ? i + 1 : 0])});
      ++d.degree[d.edges.back().from];
      ++d.degree[d.edges.back().to];
    }
  }
  d.exterior_faces = alone.loops.size();
  return d;
}

}  // namespace strata::planar
