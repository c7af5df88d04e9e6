#include "extensions/scene/direction_index.h"

#include <algorithm>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/direction_index_builder.h"
#include "extensions/scene/scene_data.h"

namespace strata {

DirectionIndex::DirectionIndex(const Scene& scene, const Origin& origin, const Monitor& monitor)
    : charts_of_(origin, input_complex_of(scene).vertex_count() == 0 ? InputComplex::Coordinates{}
                                                                     : input_complex_of(scene).vertex(0)) {
  DirectionIndexBuilder(scene, origin, monitor, *this).build();
}

std::int32_t DirectionIndex::Chart::grid(std::size_t axis, double u) const {
  constexpr double end = (1 << grid_bits) - 1;
  const double g = (u - lower[axis]) * scale[axis];
  return g > 0 ? static_cast<std::int32_t>(std::min(g, end)) : 0;
}

const DirectionIndex::Node& DirectionIndex::Chart::leaf_at(std::int32_t u, std::int32_t v) const {
  std::int32_t shift = grid_bits - bits;
  const Node* node = &nodes[(static_cast<std::size_t>(v >> shift) << bits) + static_cast<std::size_t>(u >> shift)];
  while (node->count == is_inner) {
    --shift;
    node = &nodes[node->first + static_cast<std::uint32_t>(((v >> shift) & 1) * 2 + ((u >> shift) & 1))];
  }
  return *node;
}

DirectionIndex::Range DirectionIndex::range_of(const Chart& chart, std::size_t axis, const ChartVector& r) const {
  constexpr std::int32_t end = (1 << grid_bits) - 1;
  if (charts_of_.is_bounded()) {
    if (r[2].upper() <= 0 || (r[axis] - r[2]).lower() > 0 || (r[axis] + r[2]).upper() < 0) return {1, 0};
  }
  const Bounded u = r[axis] / r[2];
  if (!std::isfinite(u.lower()) || !std::isfinite(u.upper())) return {0, end};
  return {chart.grid(axis, u.lower()), chart.grid(axis, u.upper())};
}

/// The list of the one square that certainly contains the direction.
std::optional<DirectionIndex::List> DirectionIndex::list_towards(const BoundedPoint& q) const {
  const std::size_t c = charts_of_.chart_of(q);
  const Chart& chart = charts_[c];
  const ChartVector r = charts_of_.at(c, q);
  if (!(r[2].lower() > 0)) return std::nullopt;
  const Range u = range_of(chart, 0, r), v = range_of(chart, 1, r);
  if (u.first != u.last || v.first != v.last) return std::nullopt;
  if (chart.nodes.empty()) return List{};
  const Node& leaf = chart.leaf_at(u.first, v.first);
  return List{std::span(chart.entries).subspan(leaf.first, leaf.count), u.first, v.first,
              charts_of_.depth(c, q).upper()};
}

std::vector<std::uint32_t> DirectionIndex::gather_towards(const BoundedPoint& q) const {
  std::vector<std::uint32_t> faces;
  for (std::size_t c = 0; c < charts_.size(); ++c) {
    const Chart& chart = charts_[c];
    if (chart.nodes.empty()) continue;
    const ChartVector r = charts_of_.at(c, q);
    const Range u = range_of(chart, 0, r), v = range_of(chart, 1, r);
    if (u.first > u.last || v.first > v.last) continue;
    const std::int32_t shift = grid_bits - chart.bits, side = 1 << shift;
    for (std::int32_t j = v.first >> shift; j <= v.last >> shift; ++j)
      for (std::int32_t i = u.first >> shift; i <= u.last >> shift; ++i) {
        const auto root = (static_cast<std::size_t>(j) << chart.bits) + static_cast<std::size_t>(i);
        visit_leaves(chart, chart.nodes[root], {{i * side, j * side}, side}, u, v,
                     [&](const ChartSquare&, const Node& node) {
                       for (const Entry& e : std::span(chart.entries).subspan(node.first, node.count))
                         faces.push_back(e.face);
                     });
      }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void DirectionIndex::forget_footprints() {
  for (Chart& chart : charts_) {
    chart.entry_footprints = {};
    chart.footprints = {};
  }
}

std::size_t DirectionIndex::bytes() const {
  std::size_t sum = at_origin_.size() * sizeof(std::uint32_t);
  for (const Chart& c : charts_)
    sum += c.nodes.size() * sizeof(Node) + c.entries.size() * sizeof(Entry) +
           c.entry_footprints.size() * sizeof(std::uint32_t) + c.footprints.size() * sizeof(Footprint);
  return sum;
}

}  // namespace strata
