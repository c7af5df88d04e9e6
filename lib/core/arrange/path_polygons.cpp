#include "core/arrange/path_polygons.h"

#include <algorithm>
#include <cmath>

#include "core/arrange/triangle_index.h"

namespace strata {

using namespace triangle_index;

bool PathPolygons::find(std::span<const Constraint> constraints) {
  sides_.clear();
  first_.assign(1, 0);
  if (!add_ends(constraints) || !walk_border()) return false;
  traced_.assign(border_.size(), false);
  for (std::size_t i = 0; i < border_.size(); ++i)
    if (!traced_[i]) trace(static_cast<std::int32_t>(i));
  // Every constraint bounds two polygons, unless it is in a ring that does not reach the boundary of the face.
  return sides_.size() == border_.size() + 2 * constraints.size();
}

/// The position of a point that a crossing surface constructed: on an edge of this face and a face of the other
/// operand, or inside this face on an edge of the other operand.
int PathPolygons::edge_of(const SymbolicPoint& name) const {
  if (name.kind != SymbolicPoint::Kind::edge_face) return elsewhere;
  if (name.id[2] == points_.face()) return inside;
  const auto& v = points_.corners();
  for (int k = 0; k < 3; ++k)
    if (named_on_edge(name, v[at(k)], v[at(next(k))])) return k;
  return elsewhere;
}

bool PathPolygons::add_ends(std::span<const Constraint> constraints) {
  ends_.clear();
  stations_.assign(3, {});
  const auto point = [&](PointId id) {
    if (const std::int32_t known = points_.find(id); known >= 0) return known;
    const std::int32_t v = points_.add(id);
    stations_.push_back({.edge = edge_of(points_[v].name)});
    return v;
  };
  for (const Constraint& c : constraints) {
    if (c.kind != ConstraintKind::crossing || c.line.edge) return false;
    const std::int32_t tail = point(c.tail), head = point(c.head);
    const auto number = static_cast<std::int32_t>(ends_.size());
    ends_.push_back({tail, head});
    if (tail < 3 || head < 3 || stations_[at(tail)].leaving >= 0 || stations_[at(head)].arriving >= 0) return false;
    stations_[at(tail)].leaving = number;
    stations_[at(head)].arriving = number;
  }
  return std::all_of(stations_.begin() + 3, stations_.end(), [](const Station& s) {
    const int ways = (s.leaving >= 0) + (s.arriving >= 0);
    return s.edge != elsewhere && ways == (s.edge == inside ? 2 : 1);
  });
}

/// Lists the points on the boundary in order. False when two coincide.
bool PathPolygons::walk_border() {
  border_.clear();
  for (int k = 0; k < 3; ++k) {
    border_.push_back(k);
    const std::size_t begin = border_.size();
    for (std::int32_t v = 3; v < points_.size(); ++v)
      if (stations_[at(v)].edge == k) border_.push_back(v);
    if (border_.size() < begin + 2) continue;
    const auto extent = [&](int axis) { return points_[next(k)].at[at(axis)].value - points_[k].at[at(axis)].value; };
    const auto [u, v] = points_.projection();
    const int axis = std::abs(extent(u)) >= std::abs(extent(v)) ? u : v;
    const Sign along = compare(input_, axis, points_[next(k)], points_[k]);
    const auto order = [&](std::int32_t p, std::int32_t q) { return compare(input_, axis, points_[q], points_[p]); };
    const auto first = border_.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, border_.end(), [&](std::int32_t p, std::int32_t q) { return order(p, q) == along; });
    if (along == Sign::zero ||
        std::adjacent_find(first, border_.end(), [&](auto p, auto q) { return order(p, q) != along; }) != border_.end())
      return false;
  }
  for (std::size_t i = 0; i < border_.size(); ++i) stations_[at(border_[i])].place = static_cast<std::int32_t>(i);
  return true;
}

/// The polygon on the left of a piece of the boundary: follows the boundary, then each path that begins there.
void PathPolygons::trace(std::int32_t start) {
  int edge = 0;
  for (std::int32_t i = start; !traced_[at(i)];) {
    traced_[at(i)] = true;
    const std::int32_t from = border_[at(i)];
    edge = from < 3 ? from : stations_[at(from)].edge;
    sides_.push_back({from, -1 - edge, true});
    i = at(i) + 1 == border_.size() ? 0 : i + 1;
    if (border_[at(i)] >= 3) i = stations_[at(follow(border_[at(i)]))].place;
  }
  first_.push_back(sides_.size());
}

/// Adds the sides of a path from one end of it. Returns the other end.
std::int32_t PathPolygons::follow(std::int32_t from) {
  const bool forward = stations_[at(from)].leaving >= 0;
  std::int32_t p = from;
  do {
    const Station& s = stations_[at(p)];
    const std::int32_t c = forward ? s.leaving : s.arriving;
    sides_.push_back({p, c, forward});
    p = ends_[at(c)][forward ? 1 : 0];
  } while (stations_[at(p)].edge == inside);
  return p;
}

}  // namespace strata
