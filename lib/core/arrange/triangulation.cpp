#include "core/arrange/triangulation.h"

#include "core/arrange/triangle_index.h"
#include "core/exact/failure.h"

namespace strata {

using namespace triangle_index;

// Points: names, orientations, location, insertion.

void Triangulation::start(std::uint32_t face, Names names) {
  given_names_ = names;
  points_.start(face);
  triangles_.clear();
  notes_.clear();
  lines_.clear();
  other_names_.clear();
  triangles_.push_back({{0, 1, 2}, {-1, -1, -1}, {-1, -1, -1}});
  at_.assign(3, 0);
  last_ = 0;
}

std::int32_t Triangulation::add_point(PointId id) {
  if (const std::int32_t known = points_.find(id); known >= 0) return known;
  const std::int32_t v = new_vertex(points_.table().point(id));
  const Location l = locate(v);
  if (l.on == Location::On::vertex) {
    drop_vertex();
    const std::int32_t there = tri(l.triangle).v[at(l.index)];
    other_names_.push_back({there, points_.table().name(id)});
    points_.remember(id, there);
    return there;
  }
  points_.number(v, id);
  if (l.on == Location::On::side) {
    split_side({l.triangle, l.index}, v);
  } else {
    split_triangle(l.triangle, v);
  }
  improve(v);
  return v;
}

Triangulation::Location Triangulation::locate(const Point& p) {
  const std::int32_t v = new_vertex(p);
  const Location l = locate(v);
  drop_vertex();
  return l;
}

Triangulation::Location Triangulation::locate(std::int32_t p) {
  const std::size_t patience = 2 * triangles_.size() + 16;
  std::int32_t t = last_;
  for (std::size_t step = 0; t >= 0; ++step) {
    // A walk from triangle to triangle may not terminate. After a limit every triangle is tested in turn.
    if (step >= patience) t = static_cast<std::int32_t>(step - patience);
    if (at(t) >= triangles_.size()) break;
    int zeros = 0, zero = 0, other = 0, beyond = -1;
    for (int k = 0; k < 3 && beyond < 0; ++k) {
      const int i = static_cast<int>((static_cast<std::size_t>(k) + step) % 3);
      const Sign s =
          tri(t).n[at(i)] < 0 ? inner_side({t, i}, p) : orientation(tri(t).v[at(i)], tri(t).v[at(next(i))], p);
      if (s == Sign::negative) beyond = i;
      if (s == Sign::zero) {
        ++zeros;
        zero = i;
      } else {
        other = i;
      }
    }
    if (beyond >= 0) {
      if (step < patience) t = tri(t).n[at(beyond)];
      continue;
    }
    last_ = t;
    if (zeros == 0) return {t, Location::On::inside, 0};
    if (zeros == 1) return {t, Location::On::side, zero};
    return {t, Location::On::vertex, previous(other)};
  }
  fail("a point of a face lies outside its triangulation", face());
}

/// Orientation of a side on the boundary and a point: positive inside.
///
/// Names of the lowest features decide for points constructed on an edge. Otherwise, a point where another face's edge
/// crosses this face is on the inner side of this face's edge ab when orient3d(a, b, above, below) is negative for the
/// ends of that edge. This has degree 3; the orientation test has degree 8. Nearly crossing edges make this case
/// frequent.
Sign Triangulation::inner_side(Side s, std::int32_t p) const {
  const std::int32_t from = tri(s.triangle).v[at(s.index)], to = tri(s.triangle).v[at(next(s.index))];
  const SymbolicPoint& name = points_[p].name;
  const bool is_crossed = name.kind == SymbolicPoint::Kind::edge_face && name.id[2] == points_.face();
  if (given_names_ == Names::lowest && name.kind == SymbolicPoint::Kind::edge_face) {
    if (is_crossed) return Sign::positive;
    for (int i = 0; i < 3; ++i) {
      if (points_.are_on_edge(i, from, to)) return points_.are_on_edge(i, p, p) ? Sign::zero : Sign::positive;
    }
  }
  if (const auto sign = filtered_orient2d(points_.projection(), points_[from], points_[to], points_[p])) return *sign;
  if (is_crossed)
    for (int i = 0; i < 3; ++i) {
      if (!points_.are_on_edge(i, from, to)) continue;
      const auto& v = points_.corners();
      const std::uint32_t a = v[at(i)], b = v[at(next(i))], c = name.id[0], d = name.id[1];
      const Sign above = orient3d(input_, v[0], v[1], v[2], c);
      if (above != Sign::zero) return -(orient3d(input_, a, b, c, d) * above);
    }
  return orientation(from, to, p);
}

std::int32_t Triangulation::new_vertex(const Point& p) {
  at_.push_back(-1);
  return points_.add(p);
}

/// Removes the last vertex, which is in no triangle.
void Triangulation::drop_vertex() {
  points_.drop_last();
  at_.pop_back();
}

}  // namespace strata
