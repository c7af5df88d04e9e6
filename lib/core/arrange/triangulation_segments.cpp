#include <algorithm>

#include "core/arrange/triangle_index.h"
#include "core/arrange/triangulation.h"
#include "core/exact/failure.h"

namespace strata {

using namespace triangle_index;

// Segments: walking, crossing, inserting as sides, recording constraints on sides.

void Triangulation::add_constraints(std::span<const Constraint> constraints) {
  ends_.clear();
  for (const Constraint& c : constraints) {
    const std::int32_t tail = add_point(c.tail);
    ends_.emplace_back(tail, add_point(c.head));
  }
  for (std::size_t i = 0; i < constraints.size(); ++i)
    if (ends_[i].first != ends_[i].second)
      add_segment(ends_[i].first, ends_[i].second, static_cast<std::int32_t>(i), constraints[i].line);
}

void Triangulation::add_segment(std::int32_t tail, std::int32_t head, std::int32_t constraint,
                                const ConstraintLine& line) {
  if (at(constraint) >= lines_.size()) lines_.resize(at(constraint) + 1);
  lines_[at(constraint)] = line;
  while (tail != head) {
    const std::int32_t reached = advance(tail, head, line);
    mark(tail, reached, constraint);
    tail = reached;
  }
}

/// First step of the segment from -> to. Among the triangles (from, x, y) there is one with x not left and y not right
/// of it. If x or y is on the line, it is ahead, because the angle at `from` is less than 180 degrees.
Triangulation::Departure Triangulation::depart(std::int32_t from, std::int32_t to) const {
  if (find_side(from, to).triangle >= 0 || find_side(to, from).triangle >= 0) return {{}, to};
  const std::int32_t start = at_[at(from)];
  for (const bool forward : {true, false}) {
    std::int32_t t = start;
    do {
      const int i = index_of(t, from);
      const std::int32_t x = tri(t).v[at(next(i))], y = tri(t).v[at(previous(i))];
      const Sign sx = orientation(from, to, x), sy = orientation(from, to, y);
      if (sx == Sign::zero && sy == Sign::positive) return {{}, x};
      if (sy == Sign::zero && sx == Sign::negative) return {{}, y};
      if (sx == Sign::negative && sy == Sign::positive) return {{t, next(i)}, -1};
      t = tri(t).n[at(forward ? previous(i) : i)];
    } while (t >= 0 && t != start);
    if (t == start) break;
  }
  fail("a segment leaves its face", face());
}

/// Makes the first part of the segment, up to the first vertex or constraint that it meets, a side. Returns its end.
std::int32_t Triangulation::advance(std::int32_t from, std::int32_t to, const ConstraintLine& line) {
  const Departure first = depart(from, to);
  if (first.vertex >= 0) return first.vertex;
  crossed_.clear();
  std::int32_t target = -1;
  for (Side s = first.side; target < 0;) {
    if (tri(s.triangle).c[at(s.index)] >= 0) {
      target = cross_constraint(s, line);
      break;
    }
    const std::int32_t x = tri(s.triangle).v[at(s.index)], y = tri(s.triangle).v[at(next(s.index))];
    crossed_.emplace_back(x, y);
    const Side o = partner(s);
    if (o.triangle < 0) fail("a segment leaves its face", face());
    const std::int32_t z = tri(o.triangle).v[at(previous(o.index))];
    const Sign side = z == to ? Sign::zero : orientation(from, to, z);
    // o runs from y to x: its next side is x -> z (the segment passes right of z), then z -> y.
    if (side == Sign::zero) target = z;
    if (side == Sign::positive) s = {o.triangle, next(o.index)};
    if (side == Sign::negative) s = {o.triangle, previous(o.index)};
  }
  open_way(from, target, crossed_);
  return target;
}

/// Flips crossed sides until from -> to is a side. Source: Sloan 1993.
void Triangulation::open_way(std::int32_t from, std::int32_t to,
                             std::vector<std::pair<std::int32_t, std::int32_t>>& crossed) {
  for (std::size_t head = 0; head < crossed.size(); ++head) {
    const auto [x, y] = crossed[head];
    const Side s = find_side(x, y);
    if (!is_flippable(s)) {
      crossed.emplace_back(x, y);
      continue;
    }
    const Side o = partner(s);
    const std::int32_t c = tri(s.triangle).v[at(previous(s.index))], d = tri(o.triangle).v[at(previous(o.index))];
    flip(s);
    if (c == from || c == to || d == from || d == to) continue;
    const Sign sc = orientation(from, to, c), sd = orientation(from, to, d);
    if (sc * sd == Sign::negative) crossed.emplace_back(c, d);
  }
}

SymbolicPoint Triangulation::name_of_crossing(const ConstraintLine& a, const ConstraintLine& b) const {
  if (a.edge && b.edge) return SymbolicPoint::edge_edge(a.a, a.b, b.a, b.b);
  if (a.edge) return SymbolicPoint::edge_face(a.a, a.b, b.a);
  if (b.edge) return SymbolicPoint::edge_face(b.a, b.b, a.a);
  return SymbolicPoint::three_faces(face(), a.a, b.a);
}

std::uint32_t Triangulation::operand_of(const ConstraintLine& line) const {
  return line.edge ? input_.operand_of_vertex(line.a) : input_.operand_of_face(line.a);
}

void Triangulation::connect_names(bool same_operand, std::span<const std::int32_t> wanted) {
  struct Arm {
    std::int32_t end;
    ConstraintLine line;
    std::uint32_t operand;
  };
  std::vector<std::pair<std::int32_t, Arm>> arms;  // at a vertex
  const auto add = [&](std::int32_t v, std::int32_t end, const ConstraintLine& line) {
    if (wanted[at(v)] >= 0) arms.push_back({v, {end, line, operand_of(line)}});
  };
  for (const Triangle& t : triangles_)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = t.v[at(i)], b = t.v[at(next(i))];
      for (std::int32_t n = t.c[at(i)]; n >= 0; n = note(n).next) {
        if (t.n[at(i)] >= 0 && !note(n).forward) continue;  // found from the other side
        add(a, b, lines_[at(note(n).constraint)]);
        add(b, a, lines_[at(note(n).constraint)]);
      }
      for (int k = 0; k < 3 && t.n[at(i)] < 0; ++k) {  // the face's own edges
        if (!points_.are_on_edge(k, a, b)) continue;
        const auto own = ConstraintLine::along_edge(points_.corners()[at(k)], points_.corners()[at(next(k))]);
        add(a, b, own);
        add(b, a, own);
      }
    }
  std::stable_sort(arms.begin(), arms.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  for (std::size_t first = 0, last = 0; first < arms.size(); first = last) {
    const std::int32_t v = arms[first].first;
    while (last < arms.size() && arms[last].first == v) ++last;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t j = first; j < i; ++j) {
        const Arm &x = arms[i].second, &y = arms[j].second;
        if (x.line == y.line || (!same_operand && x.operand == y.operand)) continue;
        const SymbolicPoint name = name_of_crossing(x.line, y.line);
        if (name == points_[v].name || orientation(v, x.end, y.end) == Sign::zero) continue;
        other_names_.push_back({v, name});
      }
  }
}

/// Names the point where a segment on `line` crosses a constrained side, and splits the side there.
std::int32_t Triangulation::cross_constraint(Side s, const ConstraintLine& line) {
  std::int32_t v = -1;
  for (std::int32_t n = tri(s.triangle).c[at(s.index)]; n >= 0; n = note(n).next) {
    const SymbolicPoint name = name_of_crossing(line, lines_[at(note(n).constraint)]);
    if (v < 0) {
      v = new_vertex(make_point(input_, name));
    } else if (name != points_[v].name) {
      other_names_.push_back({v, name});
    }
  }
  split_side(s, v);
  return v;
}

void Triangulation::mark(std::int32_t from, std::int32_t to, std::int32_t constraint) {
  const Side s = find_side(from, to);
  if (s.triangle >= 0) add_note(s, constraint, true);
  const Side o = s.triangle >= 0 ? partner(s) : find_side(to, from);
  if (o.triangle >= 0) add_note(o, constraint, false);
}

void Triangulation::add_note(Side s, std::int32_t constraint, bool forward) {
  std::int32_t& first = tri(s.triangle).c[at(s.index)];
  notes_.push_back({constraint, forward, first});
  first = static_cast<std::int32_t>(notes_.size()) - 1;
}

}  // namespace strata
