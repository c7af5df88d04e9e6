#include "core/winding/local_windings.h"

#include <algorithm>

#include "core/cells/walk.h"

namespace strata {

Windings LocalWindings::around(const Point& q, std::uint32_t own) const { return walk(q, own, {}); }

Windings LocalWindings::above(std::uint32_t face, const Point& q, std::span<const std::uint32_t> covering) const {
  Windings w = walk(q, nobody, covering);
  // The walk ends at the face. From below it continues through the covering faces to the upper side.
  const auto& cell = cells_.cells()[cells_.cell_at(grid_of(q))];
  if (side_of_origin(input_, face, cell.origin) == Sign::positive) return w;
  for (const std::uint32_t g : covering) w.add(input_.operand_of_face(g), -to_int(same_orientation(input_, face, g)));
  return w;
}

std::array<std::int32_t, 3> LocalWindings::grid_of(const Point& q) const {
  std::array<std::int32_t, 3> low, high;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = cells_.grid().at(static_cast<int>(i), q.at[i].lower());
    high[i] = cells_.grid().at(static_cast<int>(i), q.at[i].upper());
  }
  return low == high ? low : cells_.grid().at(nearest_doubles(input_, q));
}

Windings LocalWindings::walk(const Point& q, std::uint32_t own, std::span<const std::uint32_t> through_q) const {
  const auto target = grid_of(q);
  const Cell& cell = cells_.cells()[cells_.cell_at(target)];
  Windings w = *cell.windings;
  if (own != nobody) w.set(own, 0);
  const GridBox way = GridBox::between(cells_.grid().at(cell.origin), target);
  std::uint32_t operand = nobody, end = 0;
  for (const CellFace& f : cell.faces) {
    if (f.face >= end) {
      operand = input_.operand_of_face(f.face);
      end = input_.first_face(operand) + input_.face_count(operand);
    }
    if (operand == own || !f.box.overlaps(way)) continue;
    if (std::find(through_q.begin(), through_q.end(), f.face) != through_q.end()) continue;  // not crossed
    w.add(operand, crossing(input_, f.face, cell.origin, q));
  }
  return w;
}

}  // namespace strata
