#include "strata/arrange/triangulation.h"

#include "strata/arrange/triangle_index.h"
#include "strata/exact/failure.h"

namespace strata {

using namespace triangle_index;

// Points: names, turns, location, insertion.

void Triangulation::start(std::uint32_t face, Names names) {
  face_ = face;
  given_names_ = names;
  corners_ = carriers_.face(face);
  projection_ = projection_of(carriers_, face);
  points_.clear();
  refined_.clear();
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
  const std::int32_t v = new_vertex(make_point(carriers_, name));
  const Location l = locate(v);
  if (l.on == Location::On::vertex) {
    drop_vertex();
    const std::int32_t there = tri(l.triangle).v[at(l.index)];
    equal_.emplace_back(name, points_[at(there)].name);
    remember(name, there);
    return there;
  }
  remember(name, v);
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
    // A walk from triangle to triangle may run in a circle; past all patience every triangle is asked in turn.
    if (step >= patience) t = static_cast<std::int32_t>(step - patience);
    if (at(t) >= triangles_.size()) break;
    int zeros = 0, zero = 0, other = 0, beyond = -1;
    for (int k = 0; k < 3 && beyond < 0; ++k) {
      const int i = static_cast<int>((static_cast<std::size_t>(k) + step) % 3);
      const Sign s = tri(t).n[at(i)] < 0 ? inner_side({t, i}, p) : turn(tri(t).v[at(i)], tri(t).v[at(next(i))], p);
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

bool Triangulation::is_on_edge(Side s, std::uint32_t a, std::uint32_t b) const {
  return named_on_edge(points_[at(tri(s.triangle).v[at(s.index)])].name, a, b) &&
         named_on_edge(points_[at(tri(s.triangle).v[at(next(s.index))])].name, a, b);
}

/// Turn of a side on the border and a point: positive inside.
///
/// Names of the lowest features tell where points constructed with an edge are. Otherwise, a point where another face's
/// edge crosses this face is on the inner side of an own edge ab when orient3d(a, b, above, below) is negative for the
/// ends of that edge: degree 3, where the turn itself has 8. Edges that nearly cross make this frequent.
Sign Triangulation::inner_side(Side s, std::int32_t p) const {
  const PointName& name = points_[at(p)].name;
  const bool is_crossed = name.kind == PointName::Kind::edge_face && name.id[2] == face_;
  if (given_names_ == Names::lowest && name.kind == PointName::Kind::edge_face) {
    if (is_crossed) return Sign::positive;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = corners_[at(i)], b = corners_[at(next(i))];
      if (is_on_edge(s, a, b)) return named_on_edge(name, a, b) ? Sign::zero : Sign::positive;
    }
  }
  const std::int32_t from = tri(s.triangle).v[at(s.index)], to = tri(s.triangle).v[at(next(s.index))];
  if (const auto sign = filtered_orient2d(projection_, points_[at(from)], points_[at(to)], points_[at(p)]))
    return *sign;
  if (is_crossed)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = corners_[at(i)], b = corners_[at(next(i))], c = name.id[0], d = name.id[1];
      if (!is_on_edge(s, a, b)) continue;
      const Sign above = orient3d(carriers_, corners_[0], corners_[1], corners_[2], c);
      if (above != Sign::zero) return -(orient3d(carriers_, a, b, c, d) * above);
    }
  return turn(from, to, p);
}

const RealPoint<Twofold>& Triangulation::refined(std::int32_t vertex) const {
  Refined& r = refined_[at(vertex)];
  if (!r.known) r = {refine(carriers_, points_[at(vertex)]), true};
  return r.at;
}

Sign Triangulation::turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
  if (a == b || b == c || a == c) return Sign::zero;
  const Point &p = points_[at(a)], &q = points_[at(b)], &r = points_[at(c)];
  if (const auto sign = filtered_orient2d(projection_, p, q, r)) return *sign;
  if (collinear_by_name(p, q, r)) return Sign::zero;
  if (const auto sign = refined_orient2d(projection_, refined(a), refined(b), refined(c))) return *sign;
  return exact_orient2d(carriers_, projection_, p, q, r);
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
    return named_on_face(p.name, g, v) && named_on_face(q.name, g, v) && named_on_face(r.name, g, v) && leaves_plane(v);
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

std::int32_t Triangulation::new_vertex(const Point& p) {
  points_.push_back(p);
  refined_.emplace_back();
  at_.push_back(-1);
  return static_cast<std::int32_t>(points_.size()) - 1;
}

/// Takes back the last vertex, which is in no triangle.
void Triangulation::drop_vertex() {
  points_.pop_back();
  refined_.pop_back();
  at_.pop_back();
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

}  // namespace strata
