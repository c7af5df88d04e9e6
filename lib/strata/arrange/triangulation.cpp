#include "strata/arrange/triangulation.h"

#include <algorithm>
#include <stdexcept>

#include "strata/exact/failure.h"

namespace strata {
namespace {

int next(int i) { return i == 2 ? 0 : i + 1; }
int previous(int i) { return i == 0 ? 2 : i - 1; }
std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

void Triangulation::start(std::uint32_t face) {
  face_ = face;
  corners_ = carriers_.face(face);
  projection_ = projection_of(carriers_, face);
  points_.clear();
  triangles_.clear();
  at_.clear();
  notes_.clear();
  lines_.clear();
  names_.clear();
  by_hash_.clear();
  equal_.clear();
  for (const std::uint32_t v : corners_) {
    const PointName name = PointName::input(v);
    remember(name, new_vertex(make_point(carriers_, name)));
  }
  triangles_.push_back({{0, 1, 2}, {-1, -1, -1}, {-1, -1, -1}});
  for (std::int32_t& t : at_) t = 0;
  last_ = 0;
}

std::int32_t Triangulation::add_point(const PointName& name) {
  if (const std::int32_t known = find(name); known >= 0) return known;
  const Point p = make_point(carriers_, name);
  const Location l = locate(p);
  if (l.on == Location::On::vertex) {
    const std::int32_t v = tri(l.triangle).v[at(l.index)];
    equal_.emplace_back(name, points_[at(v)].name);
    remember(name, v);
    return v;
  }
  const std::int32_t v = new_vertex(p);
  remember(name, v);
  if (l.on == Location::On::side) {
    split_side({l.triangle, l.index}, v);
  } else {
    split_triangle(l.triangle, v);
  }
  improve(v);
  return v;
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

Triangulation::Location Triangulation::locate(const Point& p) {
  const std::size_t patience = 2 * triangles_.size() + 16;
  std::int32_t t = last_;
  for (std::size_t step = 0; t >= 0; ++step) {
    // A walk from triangle to triangle may run in a circle; past all patience every triangle is asked in turn.
    if (step >= patience) t = static_cast<std::int32_t>(step - patience);
    if (at(t) >= triangles_.size()) break;
    int zeros = 0, zero = 0, other = 0, beyond = -1;
    for (int k = 0; k < 3 && beyond < 0; ++k) {
      const int i = static_cast<int>((static_cast<std::size_t>(k) + step) % 3);
      const Sign s = tri(t).n[at(i)] < 0 ? inner_side({t, i}, p)
                                         : turn(points_[at(tri(t).v[at(i)])], points_[at(tri(t).v[at(next(i))])], p);
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
  fail("a point of a face lies outside its triangulation", face_);
}

/// Turn of a side on the border and a point: positive inside. A point where another face's edge crosses this face is on
/// the inner side of an own edge ab when orient3d(a, b, above, below) is negative for the ends of that edge: degree 3, where
/// the turn itself has 8. Edges that nearly cross make this frequent.
Sign Triangulation::inner_side(Side s, const Point& p) const {
  const Point &from = points_[at(tri(s.triangle).v[at(s.index)])],
              &to = points_[at(tri(s.triangle).v[at(next(s.index))])];
  if (const auto sign = filtered_orient2d(projection_, from, to, p)) return *sign;
  if (p.name.kind == PointName::Kind::edge_face && p.name.id[2] == face_)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = corners_[at(i)], b = corners_[at(next(i))], c = p.name.id[0], d = p.name.id[1];
      if (!named_on_edge(from.name, a, b) || !named_on_edge(to.name, a, b)) continue;
      const Sign above = orient3d(carriers_, corners_[0], corners_[1], corners_[2], c);
      if (above != Sign::zero) return -(orient3d(carriers_, a, b, c, d) * above);
    }
  return turn(from, to, p);
}

Sign Triangulation::turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
  if (a == b || b == c || a == c) return Sign::zero;
  return turn(points_[at(a)], points_[at(b)], points_[at(c)]);
}

Sign Triangulation::turn(const Point& p, const Point& q, const Point& r) const {
  if (const auto sign = filtered_orient2d(projection_, p, q, r)) return *sign;
  if (collinear_by_name(p, q, r)) return Sign::zero;
  return orient2d(carriers_, projection_, p, q, r);
}

bool Triangulation::leaves_plane(const Carriers::Indices& vertices) const {
  for (const std::uint32_t v : vertices)
    if (orient3d(carriers_, corners_[0], corners_[1], corners_[2], v) != Sign::zero) return true;
  return false;
}

/// Three points of this face are collinear when one edge carries them, or when they lie on a face in another plane.
bool Triangulation::collinear_by_name(const Point& p, const Point& q, const Point& r) const {
  const auto all_on_edge = [&](std::uint32_t a, std::uint32_t b) {
    return named_on_edge(p.name, a, b) && named_on_edge(q.name, a, b) && named_on_edge(r.name, a, b);
  };
  const auto all_on_face = [&](std::uint32_t g) {
    if (g == face_) return false;
    const auto v = carriers_.face(g);
    return named_on_face(p.name, g, v) && named_on_face(q.name, g, v) && named_on_face(r.name, g, v) &&
           leaves_plane(v);
  };
  for (int i = 0; i < 3; ++i)
    if (all_on_edge(corners_[at(i)], corners_[at(next(i))])) return true;
  for (const Point* x : {&p, &q, &r}) {
    const auto& id = x->name.id;
    switch (x->name.kind) {
      case PointName::Kind::edge_edge:
        if (all_on_edge(id[0], id[1]) || all_on_edge(id[2], id[3])) return true;
        break;
      case PointName::Kind::edge_face:
        if (all_on_edge(id[0], id[1]) || all_on_face(id[2])) return true;
        break;
      case PointName::Kind::three_faces:
        if (all_on_face(id[0]) || all_on_face(id[1]) || all_on_face(id[2])) return true;
        break;
      case PointName::Kind::input:
      case PointName::Kind::weighted:
      case PointName::Kind::free:
        break;
    }
  }
  return false;
}

namespace {

constexpr std::size_t few_names = 24;

std::uint64_t hash_of(const PointName& name) {
  std::uint64_t h = static_cast<std::uint64_t>(name.kind) * 0x9e3779b97f4a7c15u;
  for (const std::uint32_t id : name.id) h = (h ^ id) * 0xff51afd7ed558ccdu + (h >> 29);
  return h;
}

}  // namespace

std::int32_t Triangulation::find(const PointName& name) const {
  if (names_.size() <= few_names) {
    for (const auto& [n, v] : names_)
      if (n == name) return v;
    return -1;
  }
  for (std::uint64_t h = hash_of(name);; ++h) {
    const auto found = by_hash_.find(h);
    if (found == by_hash_.end()) return -1;
    const auto& [n, v] = names_[at(found->second)];
    if (n == name) return v;
  }
}

void Triangulation::remember(const PointName& name, std::int32_t vertex) {
  const auto enter = [&](std::size_t i) {
    std::uint64_t h = hash_of(names_[i].first);
    while (!by_hash_.emplace(h, static_cast<std::int32_t>(i)).second) ++h;
  };
  names_.emplace_back(name, vertex);
  if (names_.size() == few_names + 1)
    for (std::size_t i = 0; i < names_.size(); ++i) enter(i);
  if (names_.size() > few_names + 1) enter(names_.size() - 1);
}

std::int32_t Triangulation::new_vertex(const Point& p) {
  points_.push_back(p);
  at_.push_back(-1);
  return static_cast<std::int32_t>(points_.size()) - 1;
}

int Triangulation::index_of(std::int32_t triangle, std::int32_t vertex) const {
  const auto& v = tri(triangle).v;
  return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
}

Triangulation::Side Triangulation::twin(Side s) const {
  const std::int32_t u = tri(s.triangle).n[at(s.index)];
  if (u < 0) return {};
  return {u, index_of(u, tri(s.triangle).v[at(next(s.index))])};
}

/// Side i of t now borders on u: tells u, too.
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
  const Side o = twin(s);
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

/// Turns the diagonal of the quadrilateral around a side: (p, q, c) and (q, p, d) become (p, d, c) and (d, q, c).
void Triangulation::flip(Side s) {
  const Side o = twin(s);
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
  const Side o = twin(s);
  const Triangle& t = tri(s.triangle);
  const Triangle& u = tri(o.triangle);
  const std::int32_t p = t.v[at(s.index)], q = t.v[at(next(s.index))], c = t.v[at(previous(s.index))],
                     d = u.v[at(previous(o.index))];
  return turn(p, d, c) == Sign::positive && turn(d, q, c) == Sign::positive;
}

bool Triangulation::prefers_flip(Side s) const {
  const Side o = twin(s);
  const auto length = [&](std::int32_t a, std::int32_t b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = points_[at(a)].at[i].value - points_[at(b)].at[i].value;
      sum += d * d;
    }
    return sum;
  };
  const std::int32_t c = tri(s.triangle).v[at(previous(s.index))], d = tri(o.triangle).v[at(previous(o.index))];
  return length(c, d) < length(tri(s.triangle).v[at(s.index)], tri(s.triangle).v[at(next(s.index))]);
}

/// Flips sides opposite to a new vertex for shorter diagonals. Ends: every flip replaces a side by one whose length, as
/// computed, is smaller, and lengths are a fixed function of the finitely many vertex pairs.
void Triangulation::improve(std::int32_t vertex) {
  stack_.clear();
  const auto push_link = [&](std::int32_t t) {
    const int i = next(index_of(t, vertex));
    stack_.emplace_back(tri(t).v[at(i)], tri(t).v[at(next(i))]);
  };
  const auto visit = [&](std::int32_t start, bool forward) {
    for (std::int32_t t = start;;) {
      push_link(t);
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
    const auto [a, b] = stack_.back();
    stack_.pop_back();
    const Side s = find_side(a, b);
    if (s.triangle < 0 || tri(s.triangle).n[at(s.index)] < 0 || tri(s.triangle).c[at(s.index)] >= 0) continue;
    if (tri(s.triangle).v[at(previous(s.index))] != vertex || !prefers_flip(s) || !is_flippable(s)) continue;
    const Side o = twin(s);
    const std::int32_t d = tri(o.triangle).v[at(previous(o.index))];
    flip(s);
    stack_.emplace_back(a, d);
    stack_.emplace_back(d, b);
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

/// First step of the segment from -> to. Among the triangles (from, x, y) there is one with x not left and y not right
/// of it; x or y on the line is ahead, since the angle at `from` is less than a half turn.
Triangulation::Departure Triangulation::depart(std::int32_t from, std::int32_t to) const {
  const std::int32_t start = at_[at(from)];
  for (const bool forward : {true, false}) {
    std::int32_t t = start;
    do {
      const int i = index_of(t, from);
      const std::int32_t x = tri(t).v[at(next(i))], y = tri(t).v[at(previous(i))];
      if (x == to || y == to) return {{}, to};
      const Sign sx = turn(from, to, x), sy = turn(from, to, y);
      if (sx == Sign::zero && sy == Sign::positive) return {{}, x};
      if (sy == Sign::zero && sx == Sign::negative) return {{}, y};
      if (sx == Sign::negative && sy == Sign::positive) return {{t, next(i)}, -1};
      t = tri(t).n[at(forward ? previous(i) : i)];
    } while (t >= 0 && t != start);
    if (t == start) break;
  }
  fail("a segment leaves its face", face_);
}

/// Makes the segment's first part, up to the first vertex or constraint that it meets, a side. Returns where it ends.
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
    const Side o = twin(s);
    if (o.triangle < 0) fail("a segment leaves its face", face_);
    const std::int32_t z = tri(o.triangle).v[at(previous(o.index))];
    const Sign side = z == to ? Sign::zero : turn(from, to, z);
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
    const Side o = twin(s);
    const std::int32_t c = tri(s.triangle).v[at(previous(s.index))], d = tri(o.triangle).v[at(previous(o.index))];
    flip(s);
    if (c == from || c == to || d == from || d == to) continue;
    const Sign sc = turn(from, to, c), sd = turn(from, to, d);
    if (sc * sd == Sign::negative) crossed.emplace_back(c, d);
  }
}

PointName Triangulation::name_of_crossing(const ConstraintLine& a, const ConstraintLine& b) const {
  if (a.edge && b.edge) return PointName::edge_edge(a.a, a.b, b.a, b.b);
  if (a.edge) return PointName::edge_face(a.a, a.b, b.a);
  if (b.edge) return PointName::edge_face(b.a, b.b, a.a);
  return PointName::three_faces(face_, a.a, b.a);
}

std::uint32_t Triangulation::operand_of(const ConstraintLine& line) const {
  return line.edge ? carriers_.operand_of_vertex(line.a) : carriers_.operand_of_face(line.a);
}

void Triangulation::connect_names(bool same_operand) {
  struct Arm {
    std::int32_t end;
    ConstraintLine line;
    std::uint32_t operand;
  };
  std::vector<std::pair<std::int32_t, Arm>> arms;  // at a vertex
  const auto add = [&](std::int32_t v, std::int32_t end, const ConstraintLine& line) {
    arms.push_back({v, {end, line, operand_of(line)}});
  };
  for (const Triangle& t : triangles_)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = t.v[at(i)], b = t.v[at(next(i))];
      for (std::int32_t n = t.c[at(i)]; n >= 0; n = note(n).next) {
        if (t.n[at(i)] >= 0 && !note(n).forward) continue;  // met from the other side
        add(a, b, lines_[at(note(n).constraint)]);
        add(b, a, lines_[at(note(n).constraint)]);
      }
      for (int k = 0; k < 3 && t.n[at(i)] < 0; ++k) {  // the face's own edges
        const std::uint32_t u = corners_[at(k)], v = corners_[at(next(k))];
        if (!named_on_edge(points_[at(a)].name, u, v) || !named_on_edge(points_[at(b)].name, u, v)) continue;
        add(a, b, ConstraintLine::along_edge(u, v));
        add(b, a, ConstraintLine::along_edge(u, v));
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
        const PointName name = name_of_crossing(x.line, y.line);
        if (name == points_[at(v)].name || turn(v, x.end, y.end) == Sign::zero) continue;
        equal_.emplace_back(name, points_[at(v)].name);
      }
  }
}

/// Names the point where a segment on `line` crosses a constrained side, and splits the side there.
std::int32_t Triangulation::cross_constraint(Side s, const ConstraintLine& line) {
  std::int32_t v = -1;
  for (std::int32_t n = tri(s.triangle).c[at(s.index)]; n >= 0; n = note(n).next) {
    const PointName name = name_of_crossing(line, lines_[at(note(n).constraint)]);
    if (v < 0) {
      v = new_vertex(make_point(carriers_, name));
      remember(name, v);
    } else if (name != points_[at(v)].name) {
      equal_.emplace_back(name, points_[at(v)].name);
    }
  }
  split_side(s, v);
  return v;
}

void Triangulation::mark(std::int32_t from, std::int32_t to, std::int32_t constraint) {
  const Side s = find_side(from, to);
  if (s.triangle >= 0) add_note(s, constraint, true);
  const Side o = s.triangle >= 0 ? twin(s) : find_side(to, from);
  if (o.triangle >= 0) add_note(o, constraint, false);
}

void Triangulation::add_note(Side s, std::int32_t constraint, bool forward) {
  std::int32_t& first = tri(s.triangle).c[at(s.index)];
  notes_.push_back({constraint, forward, first});
  first = static_cast<std::int32_t>(notes_.size()) - 1;
}

}  // namespace strata
