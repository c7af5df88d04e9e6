#include <algorithm>

#include "core/arrange/triangle_index.h"
#include "core/arrange/triangulation.h"

namespace strata {

using namespace triangle_index;

// Simple paths, all at once: the polygons between them, triangulated by cutting ears.

namespace {
/// Larger polygons use the general algorithm: cutting ears takes quadratic time.
constexpr std::size_t many_sides = 24;
}  // namespace

const PathPolygons* Triangulation::find_paths(std::span<const Constraint> constraints) {
  if (constraints.size() > many_sides || !paths_.find(constraints)) {
    start(face(), given_names_);
    return nullptr;
  }
  triangles_.clear();
  at_.assign(at(points_.size()), -1);
  halves_.assign(2 * constraints.size(), {});
  crossed_planes_.clear();
  for (const Constraint& c : constraints) lines_.push_back(c.line);
  if (input_.has_planes())
    for (const Constraint& c : constraints)
      crossed_planes_.push_back(c.line.edge ? nullptr : input_.source_plane(c.line.a));
  return &paths_;
}

/// Fills a polygon with counter-clockwise triangles, or returns false. Counter-clockwise triangles that share every
/// side, except those on the face's boundary, with one other triangle in the opposite direction cover each position of
/// the face once (theory.md, "Fast path: simple paths"). Of all ears that contain no other point, the one with the
/// shortest base is cut first.
bool Triangulation::cut_ears(std::span<const PathPolygons::Side> sides) {
  if (sides.size() > many_sides) return false;
  polygon_.clear();
  for (const auto& s : sides) polygon_.push_back({s, {}, Sign::zero, false});
  while (polygon_.size() > 3) {
    const std::size_t n = polygon_.size();
    std::size_t best = n;
    double least = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (corner_orientation(i) != Sign::positive) continue;
      const double base = squared_length(polygon_[(i + n - 1) % n].side.from, polygon_[(i + 1) % n].side.from);
      if ((best == n || base < least) && is_ear(i)) {
        best = i;
        least = base;
      }
    }
    if (best == n) return false;
    cut_ear(best);
  }
  if (polygon_.size() < 3 || corner_orientation(1) != Sign::positive) return false;
  const auto t = new_triangle(polygon_[0].side.from, polygon_[1].side.from, polygon_[2].side.from);
  for (int i = 0; i < 3; ++i) attach({t, i}, polygon_[at(i)]);
  return true;
}

Sign Triangulation::corner_orientation(std::size_t i) {
  const std::size_t n = polygon_.size();
  const PolygonSide &before = polygon_[(i + n - 1) % n], &after = polygon_[(i + 1) % n];
  PolygonSide& here = polygon_[i];
  if (!here.orientation_known) {
    here.orientation = is_straight(i) || crosses_one_plane(i)
                           ? Sign::zero
                           : orientation(before.side.from, here.side.from, after.side.from);
    here.orientation_known = true;
  }
  return here.orientation;
}

/// True at a point where the polygon continues straight along an edge of the face.
bool Triangulation::is_straight(std::size_t i) const {
  const PolygonSide &before = polygon_[i == 0 ? polygon_.size() - 1 : i - 1], &here = polygon_[i];
  return here.inner.triangle < 0 && before.inner.triangle < 0 && here.side.carrier < 0 &&
         here.side.carrier == before.side.carrier;
}

/// True at a point where the polygon continues along the same source plane, from one part of it to another.
bool Triangulation::crosses_one_plane(std::size_t i) const {
  if (crossed_planes_.empty()) return false;
  const PolygonSide &before = polygon_[i == 0 ? polygon_.size() - 1 : i - 1], &here = polygon_[i];
  if (here.inner.triangle >= 0 || before.inner.triangle >= 0 || here.side.carrier < 0 || before.side.carrier < 0)
    return false;
  const SourcePlane* plane = crossed_planes_[at(here.side.carrier)];
  return plane != nullptr && plane == crossed_planes_[at(before.side.carrier)];
}

/// Requires a counter-clockwise corner. No point of the polygon may be in the triangle or on its base.
bool Triangulation::is_ear(std::size_t i) {
  const std::size_t n = polygon_.size();
  const std::int32_t a = polygon_[(i + n - 1) % n].side.from, b = polygon_[i].side.from,
                     c = polygon_[(i + 1) % n].side.from;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const std::size_t j = (i + k) % n;
    if (corner_orientation(j) == Sign::positive) continue;
    const std::int32_t p = polygon_[j].side.from;
    if (orientation(c, a, p) != Sign::negative && orientation(a, b, p) != Sign::negative &&
        orientation(b, c, p) != Sign::negative)
      return false;
  }
  return true;
}

void Triangulation::cut_ear(std::size_t i) {
  const std::size_t n = polygon_.size(), before = (i + n - 1) % n, after = (i + 1) % n;
  const auto t = new_triangle(polygon_[before].side.from, polygon_[i].side.from, polygon_[after].side.from);
  attach({t, 0}, polygon_[before]);
  attach({t, 1}, polygon_[i]);
  polygon_[before].inner = {t, 2};
  polygon_[before].orientation_known = polygon_[after].orientation_known = false;
  polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(i));
}

std::int32_t Triangulation::new_triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
  const auto t = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back({{a, b, c}, {-1, -1, -1}, {-1, -1, -1}});
  for (const std::int32_t v : {a, b, c}) at_[at(v)] = t;
  return t;
}

/// Attaches a triangle's side to that side of the polygon.
void Triangulation::attach(Side s, const PolygonSide& given) {
  const auto join = [&](Side o) {
    tri(s.triangle).n[at(s.index)] = o.triangle;
    tri(o.triangle).n[at(o.index)] = s.triangle;
  };
  if (given.inner.triangle >= 0) {
    join(given.inner);
  } else if (const std::int32_t c = given.side.carrier; c >= 0) {
    add_note(s, c, given.side.forward);
    halves_[2 * at(c) + (given.side.forward ? 1 : 0)] = s;
    const Side other = halves_[2 * at(c) + (given.side.forward ? 0 : 1)];
    if (other.triangle >= 0) join(other);
  }
}

}  // namespace strata
