#include <cmath>

#include "core/arrange/triangle_index.h"
#include "core/arrange/triangulation.h"

namespace strata {

using namespace triangle_index;

// Triangles and their neighbours: splits, flips, search for a side.

int Triangulation::index_of(std::int32_t triangle, std::int32_t vertex) const {
  const auto& v = tri(triangle).v;
  return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
}

Triangulation::Side Triangulation::partner(Side s) const {
  const std::int32_t u = tri(s.triangle).n[at(s.index)];
  if (u < 0) return {};
  return {u, index_of(u, tri(s.triangle).v[at(next(s.index))])};
}

/// Makes u the neighbour of t across side i, and t that of u.
void Triangulation::link(std::int32_t t, int i, std::int32_t u) {
  tri(t).n[at(i)] = u;
  if (u < 0) return;
  tri(u).n[at(index_of(u, tri(t).v[at(next(i))]))] = t;
}

void Triangulation::split_triangle(std::int32_t t, std::int32_t v) {
  const Triangle old = tri(t);
  const auto u = static_cast<std::int32_t>(triangles_.size()), w = u + 1;
  tri(t) = {{old.v[0], old.v[1], v}, {old.n[0], u, w}, {old.c[0], -1, -1}};
  triangles_.push_back({{old.v[1], old.v[2], v}, {old.n[1], w, t}, {old.c[1], -1, -1}});
  triangles_.push_back({{old.v[2], old.v[0], v}, {old.n[2], t, u}, {old.c[2], -1, -1}});
  link(u, 0, old.n[1]);
  link(w, 0, old.n[2]);
  at_[at(v)] = t;
  at_[at(old.v[0])] = t;
  at_[at(old.v[1])] = t;
  at_[at(old.v[2])] = u;
}

void Triangulation::split_side(Side s, std::int32_t v) {
  const Side o = partner(s);
  const auto halve = [&](Side x) {  // (a, b, c) becomes (a, v, c) and (v, b, c)
    const Triangle old = tri(x.triangle);
    const int i = x.index, j = next(i), k = previous(i);
    const std::int32_t a = old.v[at(i)], b = old.v[at(j)], c = old.v[at(k)];
    const auto fresh = static_cast<std::int32_t>(triangles_.size());
    tri(x.triangle) = {{a, v, c}, {-1, fresh, old.n[at(k)]}, {old.c[at(i)], -1, old.c[at(k)]}};
    triangles_.push_back({{v, b, c}, {-1, old.n[at(j)], x.triangle}, {old.c[at(i)], old.c[at(j)], -1}});
    link(fresh, 1, old.n[at(j)]);
    at_[at(a)] = x.triangle;
    at_[at(c)] = x.triangle;
    at_[at(b)] = fresh;
    return fresh;
  };
  const std::int32_t near = halve(s);
  at_[at(v)] = s.triangle;
  if (o.triangle < 0) return;
  const std::int32_t far = halve(o);
  // s.triangle holds (a, v), near holds (v, b); o.triangle holds (b, v), far holds (v, a).
  tri(s.triangle).n[0] = far;
  tri(far).n[0] = s.triangle;
  tri(near).n[0] = o.triangle;
  tri(o.triangle).n[0] = near;
}

/// Flips the diagonal of the quadrilateral around a side: (p, q, c) and (q, p, d) become (p, d, c) and (d, q, c).
void Triangulation::flip(Side s) {
  const Side o = partner(s);
  const Triangle t = tri(s.triangle), u = tri(o.triangle);
  const int i = s.index, j = o.index;
  const std::int32_t p = t.v[at(i)], q = t.v[at(next(i))], c = t.v[at(previous(i))], d = u.v[at(previous(j))];
  const std::int32_t n_qc = t.n[at(next(i))], n_cp = t.n[at(previous(i))], n_pd = u.n[at(next(j))],
                     n_dq = u.n[at(previous(j))];
  tri(s.triangle) = {{p, d, c}, {n_pd, o.triangle, n_cp}, {u.c[at(next(j))], -1, t.c[at(previous(i))]}};
  tri(o.triangle) = {{d, q, c}, {n_dq, n_qc, s.triangle}, {u.c[at(previous(j))], t.c[at(next(i))], -1}};
  link(s.triangle, 0, n_pd);
  link(o.triangle, 1, n_qc);
  at_[at(p)] = at_[at(c)] = at_[at(d)] = s.triangle;
  at_[at(q)] = o.triangle;
}

bool Triangulation::is_flippable(Side s) const {
  const Side o = partner(s);
  const Triangle& t = tri(s.triangle);
  const Triangle& u = tri(o.triangle);
  const std::int32_t p = t.v[at(s.index)], q = t.v[at(next(s.index))], c = t.v[at(previous(s.index))],
                     d = u.v[at(previous(o.index))];
  return orientation(p, d, c) == Sign::positive && orientation(d, q, c) == Sign::positive;
}

double Triangulation::squared_length(std::int32_t a, std::int32_t b) const {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = points_[a].at[i].value - points_[b].at[i].value;
    sum += d * d;
  }
  return sum;
}

bool Triangulation::prefers_flip(Side s) const {
  const Side o = partner(s);
  const std::int32_t c = tri(s.triangle).v[at(previous(s.index))], d = tri(o.triangle).v[at(previous(o.index))];
  return squared_length(c, d) < squared_length(tri(s.triangle).v[at(s.index)], tri(s.triangle).v[at(next(s.index))]);
}

/// Flips sides opposite to a new vertex for shorter diagonals. This terminates: every flip replaces a side by one whose
/// computed length is smaller, and lengths are a fixed function of the finitely many vertex pairs.
void Triangulation::improve(std::int32_t vertex) {
  stack_.clear();
  const auto visit = [&](std::int32_t start, bool forward) {
    for (std::int32_t t = start;;) {
      stack_.push_back(t);
      const int i = index_of(t, vertex);
      t = tri(t).n[at(forward ? previous(i) : i)];
      if (t < 0 || t == start) return t;
    }
  };
  if (visit(at_[at(vertex)], true) < 0) {
    const std::int32_t t = at_[at(vertex)];
    const std::int32_t back = tri(t).n[at(index_of(t, vertex))];
    if (back >= 0) visit(back, false);
  }
  while (!stack_.empty()) {
    const std::int32_t t = stack_.back();
    stack_.pop_back();
    const Side s{t, next(index_of(t, vertex))};
    const std::int32_t beyond = tri(t).n[at(s.index)];
    if (beyond < 0 || tri(t).c[at(s.index)] >= 0 || !prefers_flip(s) || !is_flippable(s)) continue;
    flip(s);
    stack_.push_back(t);
    stack_.push_back(beyond);
  }
}

/// True where, in the face's projection, an angle differs from 180 degrees by less than 3.6. The same for the corners
/// in any order.
bool Triangulation::has_flat_angle(const Corners& corners) const {
  constexpr double tangent = 0x1p-4;
  const auto first = at(points_.projection().u), second = at(points_.projection().v);
  const auto is_flat_at = [&](std::int32_t v, std::int32_t a, std::int32_t b) {
    const auto &at_v = points_[v].at, &at_a = points_[a].at, &at_b = points_[b].at;
    const double ax = at_a[first].value - at_v[first].value, ay = at_a[second].value - at_v[second].value;
    const double bx = at_b[first].value - at_v[first].value, by = at_b[second].value - at_v[second].value;
    const double dot = ax * bx + ay * by;
    return dot < 0 && std::abs(ax * by - ay * bx) < -tangent * dot;
  };
  const auto [a, b, c] = corners;
  return is_flat_at(a, b, c) || is_flat_at(b, c, a) || is_flat_at(c, a, b);
}

bool Triangulation::leaves_fewer_flat(Side s) const {
  const Side o = partner(s);
  const std::int32_t p = tri(s.triangle).v[at(s.index)], q = tri(s.triangle).v[at(next(s.index))],
                     c = tri(s.triangle).v[at(previous(s.index))], d = tri(o.triangle).v[at(previous(o.index))];
  const auto flat = [this](const Corners& t, const Corners& u) {
    return static_cast<int>(has_flat_angle(t)) + static_cast<int>(has_flat_angle(u));
  };
  return flat({p, d, c}, {d, q, c}) < flat({p, q, c}, {q, p, d});
}

/// Each flip leaves fewer flat angles than there were, so there are at most as many flips. After a flip, the neighbours
/// of both triangles are tested again.
void Triangulation::avoid_flat_angles() {
  stack_.clear();
  const auto has_diagonal = [](const Triangle& t) {
    return (t.n[0] >= 0 && t.c[0] < 0) || (t.n[1] >= 0 && t.c[1] < 0) || (t.n[2] >= 0 && t.c[2] < 0);
  };
  for (std::size_t t = triangles_.size(); t-- > 0;)
    if (has_diagonal(triangles_[t]) && has_flat_angle(triangles_[t].v)) stack_.push_back(static_cast<std::int32_t>(t));
  while (!stack_.empty()) {
    const std::int32_t t = stack_.back();
    stack_.pop_back();
    if (!has_flat_angle(tri(t).v)) continue;
    for (int i = 0; i < 3; ++i) {
      const Side s{t, i};
      const std::int32_t beyond = tri(t).n[at(i)];
      if (beyond < 0 || tri(t).c[at(i)] >= 0 || !leaves_fewer_flat(s) || !is_flippable(s)) continue;
      flip(s);
      for (const std::int32_t changed : {t, beyond}) {
        stack_.push_back(changed);
        for (std::size_t k = 0; k < 3; ++k)
          if (tri(changed).n[k] >= 0 && tri(changed).c[k] < 0) stack_.push_back(tri(changed).n[k]);
      }
      break;
    }
  }
}

/// The side that runs from a to b, if there is one.
Triangulation::Side Triangulation::find_side(std::int32_t a, std::int32_t b) const {
  const std::int32_t start = at_[at(a)];
  for (const bool forward : {true, false}) {
    std::int32_t t = start;
    do {
      const int i = index_of(t, a);
      if (tri(t).v[at(next(i))] == b) return {t, i};
      t = tri(t).n[at(forward ? previous(i) : i)];
    } while (t >= 0 && t != start);
    if (t == start) break;
  }
  return {};
}

}  // namespace strata
