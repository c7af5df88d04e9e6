#include <algorithm>
#include <map>

#include "strata/planar.h"

namespace strata::planar {

Rational area(const Region& region) { return twice_area(region.loops) / 2; }

Rational area(const Region& region, std::uint32_t polygon) {
  Rational sum = 0;
  for (std::uint32_t l = region.first_loop[polygon]; l < region.first_loop[polygon + 1]; ++l)
    sum += twice_area(region.loops, region.loops.loop(l));
  return sum / 2;
}

PolygonKind kind_of(const Region& region, std::uint32_t polygon) {
  // Loops and the vertices they share form a forest (a cycle of touching loops would cut the polygon in two). The
  // polygon is simply connected when all holes are connected to the outer loop.
  const std::uint32_t first = region.first_loop[polygon], count = region.first_loop[polygon + 1] - first;
  std::vector<std::uint32_t> group(count);
  for (std::uint32_t i = 0; i < count; ++i) group[i] = i;
  const auto find = [&](std::uint32_t i) {
    while (group[i] != i) i = group[i];
    return i;
  };
  PolygonKind kind;
  std::map<std::uint32_t, std::uint32_t> loop_at;
  std::uint32_t groups = count;
  for (std::uint32_t i = 0; i < count; ++i)
    for (const std::uint32_t v : region.loops.loop(first + i)) {
      const auto [at, is_new] = loop_at.try_emplace(v, i);
      if (is_new) continue;
      kind.is_manifold = false;
      const std::uint32_t p = find(at->second), q = find(i);
      if (p != q) --groups;
      group[std::max(p, q)] = std::min(p, q);
    }
  kind.is_simply_connected = groups == 1;
  return kind;
}

std::vector<std::vector<RationalPlacement>> canonical_form(const Region& region) {
  std::vector<std::vector<RationalPlacement>> form;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    auto& loop = form.emplace_back();
    for (const std::uint32_t v : region.loops.loop(l)) loop.push_back(exact_position(region.loops.places, v));
  }
  std::sort(form.begin(), form.end());
  return form;
}

}  // namespace strata::planar
