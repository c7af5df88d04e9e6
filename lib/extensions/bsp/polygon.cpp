#include <stdexcept>
#include <utility>

#include "extensions/bsp/partition_data.h"

namespace strata::bsp {

Partition<2> partition_of(std::span<const PlaneSide> sides) {
  HyperplaneTable<2> table;
  std::vector<Facet<2>> facets;
  for (const PlaneSide& s : sides) {
    if (s.from == s.to) continue;
    const OrientedHyperplane<2> line = line_through(s.from, s.to);  // its minus side is inside
    const std::size_t axis = s.from[0] != s.to[0] ? 0 : 1;
    Piece<2> piece;
    piece.hyperplane = table.add(line.hyperplane);
    const auto corner = [&](const RationalVector<2>& p) {
      return table.meet({piece.hyperplane, table.add(axis_hyperplane<2>(axis, p[axis]))});
    };
    piece.corners = {corner(line.is_reversed ? s.to : s.from), corner(line.is_reversed ? s.from : s.to)};
    facets.push_back({std::move(piece), line.is_reversed});
  }
  Tree tree = built(table, std::move(facets));
  return compact(partition_from(std::move(table), std::move(tree)));
}

Partition<2> partition_of(std::span<const PolygonLoop> loops) {
  std::vector<PlaneSide> sides;
  for (const PolygonLoop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) sides.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return partition_of(sides);
}

std::vector<PlaneSide> sides_of(const Partition<2>& region) {
  std::vector<PlaneSide> sides;
  for (const Facet<2>& f : facets_of(region)) {
    if (!f.piece.is_bounded()) throw std::domain_error("the boundary of the region is not bounded");
    PlaneSide side{table_of(region).position(f.piece.corners[0]), table_of(region).position(f.piece.corners[1])};
    if (f.faces_plus) std::swap(side.from, side.to);
    sides.push_back(std::move(side));
  }
  return sides;
}

}  // namespace strata::bsp
