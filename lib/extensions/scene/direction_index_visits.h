#pragma once
#include <tbb/parallel_for.h>

#include <cstddef>
#include <span>

#include "extensions/scene/direction_index.h"

namespace strata {

template <class Visit>
void DirectionIndex::visit_leaves(const Chart& chart, const Node& node, const ChartSquare& square, Range u, Range v,
                                  const Visit& visit) {
  if (u.last < square.lower[0] || v.last < square.lower[1] || u.first - square.lower[0] >= square.side ||
      v.first - square.lower[1] >= square.side)
    return;
  if (node.count != is_inner) {
    visit(square, node);
    return;
  }
  for (std::uint32_t i = 0; i < 4; ++i)
    visit_leaves(chart, chart.nodes[node.first + i], quarter_of(square, i), u, v, visit);
}

template <class Visit>
void DirectionIndex::for_each_leaf(const Visit& visit) const {
  constexpr std::int32_t all = (1 << grid_bits) - 1;
  for (std::size_t c = 0; c < charts_.size(); ++c) {
    const Chart& chart = charts_[c];
    const std::int32_t side = 1 << (grid_bits - chart.bits), row = 1 << chart.bits;
    if (chart.nodes.empty()) continue;
    tbb::parallel_for(std::int32_t{0}, row, [&](std::int32_t j) {
      for (std::int32_t i = 0; i < row; ++i) {
        const auto root = static_cast<std::size_t>(j) * static_cast<std::size_t>(row) + static_cast<std::size_t>(i);
        visit_leaves(chart, chart.nodes[root], {{i * side, j * side}, side}, {0, all}, {0, all},
                     [&](const ChartSquare& square, const Node& node) {
                       if (node.count > 1)
                         visit(Leaf{c, square, std::span(chart.entry_footprints).subspan(node.first, node.count)});
                     });
      }
    });
  }
}

}  // namespace strata
