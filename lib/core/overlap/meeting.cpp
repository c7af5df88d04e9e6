#include "core/overlap/meeting.h"

#include <algorithm>

#include "core/kernel/predicates.h"
#include "core/overlap/coplanar.h"
#include "core/overlap/triangle.h"

namespace strata {
namespace {

bool all(const Signs& s, Sign x) { return s[0] == x && s[1] == x && s[2] == x; }

/// Side of a face's plane on which a vertex is.
Sign side(const InputComplex& input, std::uint32_t face, const InputComplex::Indices& v, std::uint32_t of) {
  if (input.source_plane(face) != nullptr)
    return side_of_face(input, face, make_point(input, SymbolicPoint::input(of)));
  return orient3d(input, v[0], v[1], v[2], of);
}

/// Evaluates exactly the sides about which doubles are not certain.
Signs completed(const InputComplex& input, Signs sides, const FilteredFace& plane, const FilteredFace& other) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sides[i] == Sign::zero) sides[i] = side(input, plane.face, plane.vertices, other.vertices[i]);
  return sides;
}

/// The ends of the section of a triangle, whose vertices are on sides s of a plane, with the plane. Walking around the
/// triangle counter-clockwise, it leaves the positive side at the tail and enters it at the head. So the section is
/// directed along n x n', with n the plane's normal and n' the triangle's. theory.md, "Directions".
struct Section {
  Feature tail, head;
};

Section section(const Signs& s) {
  const auto at = [&](int i) { return s[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < 3; ++i) {  // an edge in the plane
    if (at(i) != Sign::zero || at(next(i)) != Sign::zero) continue;
    const Feature a = Feature::vertex(i), b = Feature::vertex(next(i));
    return at(previous(i)) == Sign::positive ? Section{a, b} : Section{b, a};
  }
  Section r{Feature::inside(), Feature::inside()};
  for (int i = 0; i < 3; ++i) {
    if (at(i) == Sign::negative && at(next(i)) == Sign::positive) r.head = Feature::edge(i);
    if (at(i) == Sign::positive && at(next(i)) == Sign::negative) r.tail = Feature::edge(i);
  }
  for (int i = 0; i < 3; ++i) {  // a vertex in the plane is the end that is missing
    if (at(i) != Sign::zero) continue;
    if (r.head == Feature::inside()) r.head = Feature::vertex(i);
    if (r.tail == Feature::inside()) r.tail = Feature::vertex(i);
  }
  return r;
}

/// The index of an edge that lies in the plane, for a triangle with these sides; -1 if there is none.
int edge_in_plane(const Signs& s) {
  for (int i = 0; i < 3; ++i)
    if (s[static_cast<std::size_t>(i)] == Sign::zero && s[static_cast<std::size_t>(next(i))] == Sign::zero) return i;
  return -1;
}

bool reaches(const Signs& s, Sign side) { return s[0] == side || s[1] == side || s[2] == side; }

/// Two triangles in different planes, each of which meets the other's plane.
class TransversalMeeting {
 public:
  TransversalMeeting(const InputComplex& input, const FilteredFace& f, const FilteredFace& g, const Signs& of_f,
                     const Signs& of_g)
      : input_(input),
        face_f_(f),
        face_g_(g),
        f_(f.face),
        g_(g.face),
        vf_(f.vertices),
        vg_(g.vertices),
        of_f_(of_f),
        of_g_(of_g) {}

  bool find(PairIntersections& intersections) {
    // Both sections lie on one line. Along n_f x n_g, the section of g has its own direction and that of f the opposite
    // one.
    const Section on_g = section(of_g_), on_f = section(of_f_);
    const auto tail = later(on_f.head, on_g.tail);
    if (!tail) return false;
    const auto head = later(on_f.tail, on_g.head);
    if (!head) return false;
    if (is_shared(*tail) && is_shared(*head)) return false;
    append(intersections, *tail, *head);
    return true;
  }

 private:
  /// Of two candidates for an end, one from each triangle, the one that lies in both triangles.
  std::optional<SharedPoint> later(Feature from_f, Feature from_g) {
    if (const auto on_g = locate(sides_in_g(from_f))) return SharedPoint{from_f, *on_g};
    if (const auto on_f = locate(sides_in_f(from_g))) return SharedPoint{*on_f, from_g};
    return std::nullopt;
  }

  /// The edge through an end of a section that leaves the other plane there.
  static int edge_through(Feature end, const Signs& s) {
    if (end.kind == Feature::Kind::edge) return end.index;
    return s[static_cast<std::size_t>(next(end.index))] != Sign::zero ? end.index : previous(end.index);
  }
  Signs sides_in_g(Feature end) {
    const int i = edge_through(end, of_f_);
    return {between(i, 0), between(i, 1), between(i, 2)};
  }
  Signs sides_in_f(Feature end) {
    const int k = edge_through(end, of_g_);
    return {between(0, k), between(1, k), between(2, k)};
  }
  Sign between(int i, int k) {
    auto& known = between_[3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(k)];
    if (!known) known = orient_edges(input_, face_f_, i, face_g_, k);
    return *known;
  }

  [[nodiscard]] bool is_shared(const SharedPoint& p) const {
    return p.on_f.kind == Feature::Kind::vertex && p.on_g.kind == Feature::Kind::vertex &&
           vf_[p.on_f.index] == vg_[p.on_g.index];
  }

  void append(PairIntersections& intersections, const SharedPoint& tail, const SharedPoint& head) const {
    note_equal(intersections, tail);
    note_equal(intersections, head);
    const auto on_f = [&](const SharedPoint& p) { return intersections.number(input_, name_of(p, f_, vf_, g_, vg_)); };
    const auto on_g = [&](const SharedPoint& p) {
      return intersections.number(input_, name_of({p.on_g, p.on_f}, g_, vg_, f_, vf_));
    };
    const PointId tail_f = on_f(tail), head_f = on_f(head), tail_g = on_g(tail), head_g = on_g(head);
    if (tail == head) {
      intersections.constraints.push_back(
          {f_, g_, ConstraintKind::point, ConstraintLine::trace_of(g_), tail_f, tail_f});
      intersections.constraints.push_back(
          {g_, f_, ConstraintKind::point, ConstraintLine::trace_of(f_), tail_g, tail_g});
      return;
    }
    const auto kind = [](const Signs& s) {
      return reaches(s, Sign::positive) ? ConstraintKind::crossing : ConstraintKind::touch;
    };
    intersections.constraints.push_back({f_, g_, kind(of_g_), line(g_), tail_f, head_f});
    intersections.constraints.push_back({g_, f_, kind(of_f_), line(f_), head_g, tail_g});
  }

  void note_equal(PairIntersections& intersections, const SharedPoint& p) const {
    if (p.on_f.kind != Feature::Kind::vertex || p.on_g.kind != Feature::Kind::vertex || is_shared(p)) return;
    intersections.equal.push_back({vf_[p.on_f.index], vg_[p.on_g.index]});
  }

  /// The line of the section in the other face: an edge of either triangle if one lies there, otherwise a trace.
  [[nodiscard]] ConstraintLine line(std::uint32_t other) const {
    const auto along = [](const InputComplex::Indices& v, int i) {
      return ConstraintLine::along_edge(v[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(next(i))]);
    };
    const int ef = edge_in_plane(of_f_), eg = edge_in_plane(of_g_);
    if (ef >= 0 && eg >= 0) return std::min(along(vf_, ef), along(vg_, eg));
    if (ef >= 0) return along(vf_, ef);
    if (eg >= 0) return along(vg_, eg);
    return ConstraintLine::trace_of(other);
  }

  const InputComplex& input_;
  const FilteredFace &face_f_, &face_g_;
  std::uint32_t f_, g_;
  const InputComplex::Indices &vf_, &vg_;
  const Signs &of_f_, &of_g_;
  std::array<std::optional<Sign>, 9> between_{};
};

int common_vertices(const InputComplex::Indices& f, const InputComplex::Indices& g) {
  int n = 0;
  for (const std::uint32_t a : f)
    for (const std::uint32_t b : g) n += static_cast<int>(a == b);
  return n;
}

bool is_coplanar(const InputComplex& input, const FilteredFace& f, const FilteredFace& g) {
  for (const std::uint32_t v : g.vertices)
    if (!f.has(v) && side(input, f.face, f.vertices, v) != Sign::zero) return false;
  return true;
}

/// Two coplanar faces that are not known to be apart.
bool meet_or_list(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                  PairIntersections& intersections) {
  if (!intersections.leaves_coplanar) return meet_coplanar_faces(input, f, g, intersections);
  intersections.coplanar.push_back({f.face, g.face});
  return false;
}

bool meet_in_one_plane(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                       PairIntersections& intersections) {
  if (f.is_off(g) || g.is_off(f)) return false;
  if (common_vertices(f.vertices, g.vertices) == 3)
    return meet_same_face(f.face, f.vertices, g.face, g.vertices, intersections);
  return meet_or_list(input, f, g, intersections);
}

}  // namespace

bool meet_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                PairIntersections& intersections) {
  if (f.is_level_as(g)) return f.level() == g.level() && meet_in_one_plane(input, f, g, intersections);
  const Signs of_g = f.sides_of(g);
  if (f.is_beside(g, of_g)) return false;
  const Signs of_f = g.sides_of(f);
  return !g.is_beside(f, of_f) && meet_faces(input, f, g, of_f, of_g, intersections);
}

bool meet_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g, Signs of_f, Signs of_g,
                PairIntersections& intersections) {
  if (f.is_off(g) || g.is_off(f)) return false;
  const int common = common_vertices(f.vertices, g.vertices);
  if (common == 3) return meet_same_face(f.face, f.vertices, g.face, g.vertices, intersections);
  if (common == 2 && !is_coplanar(input, f, g)) return false;
  of_g = completed(input, of_g, f, g);
  if (all(of_g, Sign::positive) || all(of_g, Sign::negative)) return false;
  if (all(of_g, Sign::zero)) return meet_or_list(input, f, g, intersections);
  of_f = completed(input, of_f, g, f);
  if (all(of_f, Sign::positive) || all(of_f, Sign::negative)) return false;
  return TransversalMeeting(input, f, g, of_f, of_g).find(intersections);
}

}  // namespace strata
