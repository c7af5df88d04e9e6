#include "extensions/complex/face_cutter.h"

#include <algorithm>

#include "core/exact/failure.h"
#include "core/kernel/predicates.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

void FaceCutter::keep_whole(Index face) {
  const auto v = input_.face(face);
  for (std::size_t i = 0; i < 3; ++i) add_side_part(face, static_cast<int>(i), v[i], v[(i + 1) % 3]);
  add_piece(face, v, {});
}

void FaceCutter::cut(std::span<const Constraint> constraints) {
  face_ = constraints.front().face;
  constraints_ = constraints;
  triangulate();
  number_.assign(at(triangulation_.points().size()), none);
  list_coplanar();
  spread();
  add_border();
}

void FaceCutter::triangulate() {
  triangulation_.start(face_, Triangulation::Names::lowest);
  triangulation_.add_constraints(constraints_);
  triangulation_.avoid_flat_angles();
}

void FaceCutter::list_coplanar() {
  coplanar_here_.clear();
  for (const Constraint& c : constraints_)
    if (c.kind == ConstraintKind::coplanar) coplanar_here_.push_back(c.other);
  std::sort(coplanar_here_.begin(), coplanar_here_.end());
  coplanar_here_.erase(std::unique(coplanar_here_.begin(), coplanar_here_.end()), coplanar_here_.end());
  for (const Index g : coplanar_here_) coplanar.emplace_back(face_, g);
}

/// Traverses the triangles from one whose covering faces are known. Across the edges of a coplanar face, its covering
/// begins or ends.
void FaceCutter::spread() {
  const auto triangles = triangulation_.triangles();
  done_.assign(triangles.size(), false);
  const auto [start, covers_there] = place_inside();
  stack_.assign(1, {start, covers_there});
  done_[at(start)] = true;
  while (!stack_.empty()) {
    const auto [t, covered] = std::move(stack_.back());
    stack_.pop_back();
    const auto& triangle = triangles[at(t)];
    if (covered.empty() || covered.front() > face_)
      add_piece(face_, {number_of(triangle.v[0]), number_of(triangle.v[1]), number_of(triangle.v[2])}, covered);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t n = triangle.n[i];
      if (n < 0 || done_[at(n)]) continue;
      done_[at(n)] = true;
      stack_.emplace_back(n, across(covered, triangle.c[i]));
    }
  }
}

/// A position off all constraints: each constraint contains at most two points of the conic of weighted points.
std::pair<std::int32_t, std::vector<Index>> FaceCutter::place_inside() {
  for (Index t = 1; t <= SymbolicPoint::weight_limit; ++t) {
    const Point q = make_point(input_, SymbolicPoint::weighted(face_, t));
    const auto place = triangulation_.locate(q);
    using On = Triangulation::Location::On;
    if (place.on == On::vertex) continue;
    if (place.on == On::side && triangulation_.triangles()[at(place.triangle)].c[at(place.index)] >= 0) continue;
    std::vector<Index> covered;
    for (const Index g : coplanar_here_)
      if (holds(g, q)) covered.push_back(g);
    return {place.triangle, covered};
  }
  fail("no point inside a face off its constraints", face_);
}

bool FaceCutter::holds(Index g, const Point& q) const {
  const Projection seen = projection_of(input_, g);
  const auto v = input_.face(g);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = make_point(input_, SymbolicPoint::input(v[i]));
    const Point b = make_point(input_, SymbolicPoint::input(v[(i + 1) % 3]));
    if (orient2d(input_, seen, a, b, q) != Sign::positive) return false;
  }
  return true;
}

std::vector<Index> FaceCutter::across(std::vector<Index> covered, std::int32_t first_note) const {
  for (std::int32_t n = first_note; n >= 0; n = triangulation_.note(n).next) {
    const auto& note = triangulation_.note(n);
    const Constraint& c = constraints_[at(note.constraint)];
    if (c.kind != ConstraintKind::cover_left && c.kind != ConstraintKind::cover_right) continue;
    const bool enters = (c.kind == ConstraintKind::cover_left) != note.forward;
    const auto where = std::lower_bound(covered.begin(), covered.end(), c.other);
    const bool there = where != covered.end() && *where == c.other;
    if (enters && !there) covered.insert(where, c.other);
    if (!enters && there) covered.erase(where);
  }
  return covered;
}

/// From corner to corner along the boundary.
void FaceCutter::add_border() {
  const auto triangles = triangulation_.triangles();
  next_.assign(number_.size(), -1);
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t.n[i] < 0) next_[at(t.v[i])] = t.v[(i + 1) % 3];
  for (int side = 0; side < 3; ++side)
    for (std::int32_t v = side; v != (side + 1) % 3; v = next_[at(v)])
      add_side_part(face_, side, number_of(v), number_of(next_[at(v)]));
}

void FaceCutter::add_side_part(Index face, int side, Index a, Index b) { side_parts.push_back({{a, b}, face, side}); }

void FaceCutter::add_piece(Index face, std::array<Index, 3> v, const std::vector<Index>& covered) {
  if (is_reversed_[face] != 0) std::swap(v[1], v[2]);
  pieces.push_back({v, face, static_cast<Index>(covers.size()), static_cast<Index>(covered.size())});
  covers.insert(covers.end(), covered.begin(), covered.end());
}

PointId FaceCutter::number_of(std::int32_t v) {
  Index& number = number_[at(v)];
  if (number != none) return number;
  number = triangulation_.points().id(v);
  if (number == FacePoints::unnumbered) {
    number = points_.end() + static_cast<Index>(constructed.size());
    constructed.push_back(triangulation_.points()[v].name);
  }
  return number;
}

}  // namespace strata::complex
