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

GridBox LocalWindings::box_of(std::uint32_t operand, std::uint32_t face) const {
  const auto points = input_.points(operand);
  const auto& [a, b, c] = input_.faces(operand)[face - input_.first_face(operand)];
  return cells_.grid().box(points[a], points[b], points[c]);
}

Windings LocalWindings::walk(const Point& q, std::uint32_t own, std::span<const std::uint32_t> through_q) const {
  const auto target = grid_of(q);
  const Cell& cell = cells_.cells()[cells_.cell_at(target)];
  Windings w = *cell.windings;
  if (own != nobody) w.set(own, 0);
  const GridBox way = GridBox::between(cells_.grid().at(cell.origin), target);
  std::uint32_t operand = nobody, end = 0;
  const auto is_counted = [&](std::uint32_t face) {
    if (face >= end) {
      operand = input_.operand_of_face(face);
      end = input_.first_face(operand) + input_.face_count(operand);
    }
    return operand != own && std::find(through_q.begin(), through_q.end(), face) == through_q.end();
  };
  for (const CellFace& f : cell.faces)
    if (is_counted(f.face) && f.box.overlaps(way)) w.add(operand, crossing(input_, f.face, cell.origin, q));
  for (const std::uint32_t f : cell.numbers)
    if (is_counted(f) && box_of(operand, f).overlaps(way)) w.add(operand, crossing(input_, f, cell.origin, q));
  return w;
}

}  // namespace strata
