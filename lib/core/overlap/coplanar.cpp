#include "core/overlap/coplanar.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>

#include "core/kernel/predicates.h"
#include "core/overlap/triangle.h"

namespace strata {
namespace {

/// Points in which an edge meets a triangle. An edge and a convex set share at most a segment, so there are at most two
/// ends.
using Ends = boost::container::static_vector<SharedPoint, 8>;

/// A triangle in a projection.
class SeenTriangle {
 public:
  SeenTriangle(const InputComplex& input, const FilteredFace& face, Projection projection)
      : input_(input), face_(face), projection_(projection) {
    for (std::size_t i = 0; i < 3; ++i) seen_[i] = seen(face.corners[i], projection);
  }

  /// Sides of the triangle's directed edge e on which the corners of another one lie: left positive.
  [[nodiscard]] Sign side(std::size_t e, const SeenTriangle& other, std::size_t p) const {
    const std::size_t n = (e + 1) % 3;
    if (face_.is_exact && other.face_.is_exact) return orient2d(seen_[e], seen_[n], other.seen_[p]);
    return orient2d(input_, projection_, point(e), point(n), other.point(p));
  }
  [[nodiscard]] Point point(std::size_t i) const { return make_point(input_, SymbolicPoint::input(face_.vertices[i])); }

  /// Positive when counter-clockwise.
  [[nodiscard]] Sign orientation() const { return side(0, *this, 2); }

  /// A projection in which the face is counter-clockwise.
  static Projection projection_for(const InputComplex& input, const FilteredFace& face) {
    if (face.is_exact) {
      const int axis = static_cast<int>(face.plane.widest_axis()), u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Sign s = SeenTriangle(input, face, {u, v}).orientation();
      if (s != Sign::zero) return s == Sign::positive ? Projection{u, v} : Projection{v, u};
    }
    return projection_of(input, face.face);
  }

 private:
  static PlanePoint seen(const InputComplex::Coordinates& p, Projection projection) {
    return {p[static_cast<std::size_t>(projection.u)], p[static_cast<std::size_t>(projection.v)]};
  }

  const InputComplex& input_;
  const FilteredFace& face_;
  Projection projection_;
  std::array<PlanePoint, 3> seen_;
};

/// Both triangles in the projection in which f is counter-clockwise.
class CoplanarMeeting {
 public:
  CoplanarMeeting(const InputComplex& input, const FilteredFace& f, const FilteredFace& g)
      : input_(input),
        f_(f.face),
        g_(g.face),
        vf_(f.vertices),
        vg_(g.vertices),
        projection_(SeenTriangle::projection_for(input, f)),
        seen_f_(input, f, projection_),
        seen_g_(input, g, projection_),
        orientation_(seen_g_.orientation()) {}

  bool find(PairIntersections& intersections) {
    for (std::size_t e = 0; e < 3; ++e) {
      for (std::size_t p = 0; p < 3; ++p) g_vertex_side_[p][e] = seen_f_.side(e, seen_g_, p);
      if (is_beyond(e)) return false;
    }
    for (std::size_t e = 0; e < 3; ++e)
      for (std::size_t p = 0; p < 3; ++p) f_vertex_side_[p][e] = seen_g_.side(e, seen_f_, p);
    for (std::size_t i = 0; i < 3; ++i) {
      f_vertex_in_g_[i] = locate(f_vertex_side_[i], orientation_);
      g_vertex_in_f_[i] = locate(g_vertex_side_[i], Sign::positive);
    }
    std::array<Ends, 3> g_edges, f_edges;
    bool any = false;
    for (int k = 0; k < 3; ++k) {
      g_edges[static_cast<std::size_t>(k)] = ends_of_g_edge(k);
      f_edges[static_cast<std::size_t>(k)] = ends_of_f_edge(k);
      for (const SharedPoint& p : g_edges[static_cast<std::size_t>(k)]) any = any || !is_shared(p);
      for (const SharedPoint& p : f_edges[static_cast<std::size_t>(k)]) any = any || !is_shared(p);
    }
    if (!any) return false;  // nothing but shared vertices
    meet_same_face(f_, vf_, g_, vg_, intersections);
    for (int k = 0; k < 3; ++k) {
      append_to_f(intersections, k, g_edges[static_cast<std::size_t>(k)]);
      append_to_g(intersections, k, f_edges[static_cast<std::size_t>(k)]);
    }
    return true;
  }

 private:
  /// True when all of g is strictly on the outer side of an edge of f, except vertices on that edge that f has, too.
  [[nodiscard]] bool is_beyond(std::size_t edge) const {
    for (std::size_t p = 0; p < 3; ++p) {
      const Sign s = g_vertex_side_[p][edge];
      const bool is_end = vg_[p] == vf_[edge] || vg_[p] == vf_[(edge + 1) % 3];
      if (s != Sign::negative && !is_end) return false;
    }
    return true;
  }
  [[nodiscard]] const std::optional<Feature>& f_vertex_in_g(int i) const {
    return f_vertex_in_g_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const std::optional<Feature>& g_vertex_in_f(int k) const {
    return g_vertex_in_f_[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] bool cross_properly(int i, int k) const {
    const auto e = static_cast<std::size_t>(i), h = static_cast<std::size_t>(k);
    const Sign g1 = g_vertex_side_[h][e], g2 = g_vertex_side_[(h + 1) % 3][e];
    const Sign f1 = f_vertex_side_[e][h], f2 = f_vertex_side_[(e + 1) % 3][h];
    return g1 * g2 == Sign::negative && f1 * f2 == Sign::negative;
  }
  static void add(Ends& ends, SharedPoint p) {
    if (std::find(ends.begin(), ends.end(), p) == ends.end()) ends.push_back(p);
  }

  [[nodiscard]] Ends ends_of_g_edge(int k) const {
    Ends ends;
    for (const int v : {k, next(k)})
      if (const auto on_f = g_vertex_in_f(v)) add(ends, {*on_f, Feature::vertex(v)});
    for (int i = 0; i < 3; ++i) {
      if (cross_properly(i, k)) add(ends, {Feature::edge(i), Feature::edge(k)});
      const auto on_g = f_vertex_in_g(i);
      if (on_g && *on_g == Feature::edge(k)) add(ends, {Feature::vertex(i), Feature::edge(k)});
    }
    return ends;
  }
  [[nodiscard]] Ends ends_of_f_edge(int i) const {
    Ends ends;
    for (const int v : {i, next(i)})
      if (const auto on_g = f_vertex_in_g(v)) add(ends, {Feature::vertex(v), *on_g});
    for (int k = 0; k < 3; ++k) {
      if (cross_properly(i, k)) add(ends, {Feature::edge(i), Feature::edge(k)});
      const auto on_f = g_vertex_in_f(k);
      if (on_f && *on_f == Feature::edge(i)) add(ends, {Feature::edge(i), Feature::vertex(k)});
    }
    return ends;
  }

  [[nodiscard]] bool is_shared(const SharedPoint& p) const {
    return p.on_f.kind == Feature::Kind::vertex && p.on_g.kind == Feature::Kind::vertex &&
           vf_[p.on_f.index] == vg_[p.on_g.index];
  }
  /// The position of an end on edge k of g, as far as features decide it: at its start or where it enters f, in
  /// between, at its end or where it leaves f.
  [[nodiscard]] int place_on_g(const SharedPoint& p, int k) const {
    if (p.on_g.kind == Feature::Kind::vertex) return p.on_g.index == k ? 0 : 2;
    if (p.on_f.kind != Feature::Kind::edge) return 1;
    return g_vertex_side_[static_cast<std::size_t>(k)][p.on_f.index] == Sign::negative ? 0 : 2;
  }
  [[nodiscard]] int place_on_f(const SharedPoint& p, int i) const {
    if (p.on_f.kind == Feature::Kind::vertex) return p.on_f.index == i ? 0 : 2;
    if (p.on_g.kind != Feature::Kind::edge) return 1;
    return f_vertex_side_[static_cast<std::size_t>(i)][p.on_g.index] == -orientation_ ? 0 : 2;
  }
  /// Orders two ends along edge e of a triangle, by these positions if they differ.
  void order(Ends& ends, const SeenTriangle& triangle, std::size_t e, int first_place, int last_place) const {
    if (first_place > last_place) std::swap(ends[0], ends[1]);
    if (first_place != last_place) return;
    const Point p = make_point(input_, name_of(ends[0], f_, vf_, g_, vg_));
    const Point q = make_point(input_, name_of(ends[1], f_, vf_, g_, vg_));
    for (const int axis : {projection_.u, projection_.v}) {
      const Sign along = compare(input_, axis, triangle.point((e + 1) % 3), triangle.point(e));
      if (along == Sign::zero) continue;
      if (compare(input_, axis, q, p) != along) std::swap(ends[0], ends[1]);
      return;
    }
  }
  void note_equal(PairIntersections& intersections, const Ends& ends) const {
    for (const SharedPoint& p : ends)
      if (p.on_f.kind == Feature::Kind::vertex && p.on_g.kind == Feature::Kind::vertex && !is_shared(p))
        intersections.equal.push_back({vf_[p.on_f.index], vg_[p.on_g.index]});
  }

  void append_to_f(PairIntersections& intersections, int k, Ends ends) const {
    if (ends.empty()) return;
    const auto a = static_cast<std::size_t>(k), b = (a + 1) % 3;
    if (ends.size() == 2) order(ends, seen_g_, a, place_on_g(ends[0], k), place_on_g(ends[1], k));
    note_equal(intersections, ends);
    const bool left = orientation_ == Sign::positive;
    const ConstraintKind kind = ends.size() == 1 ? ConstraintKind::point
                                : left           ? ConstraintKind::cover_left
                                                 : ConstraintKind::cover_right;
    const auto number = [&](const SharedPoint& p) {
      return intersections.number(input_, name_of(p, f_, vf_, g_, vg_));
    };
    intersections.constraints.push_back(
        {f_, g_, kind, ConstraintLine::along_edge(vg_[a], vg_[b]), number(ends.front()), number(ends.back())});
  }
  void append_to_g(PairIntersections& intersections, int i, Ends ends) const {
    if (ends.empty()) return;
    const auto a = static_cast<std::size_t>(i), b = (a + 1) % 3;
    if (ends.size() == 2) order(ends, seen_f_, a, place_on_f(ends[0], i), place_on_f(ends[1], i));
    const bool left = orientation_ == Sign::positive;
    const ConstraintKind kind = ends.size() == 1 ? ConstraintKind::point
                                : left           ? ConstraintKind::cover_left
                                                 : ConstraintKind::cover_right;
    const auto number = [&](const SharedPoint& p) {
      return intersections.number(input_, name_of({p.on_g, p.on_f}, g_, vg_, f_, vf_));
    };
    intersections.constraints.push_back(
        {g_, f_, kind, ConstraintLine::along_edge(vf_[a], vf_[b]), number(ends.front()), number(ends.back())});
  }

  const InputComplex& input_;
  std::uint32_t f_, g_;
  InputComplex::Indices vf_, vg_;
  Projection projection_;
  SeenTriangle seen_f_, seen_g_;
  Sign orientation_;
  std::array<Signs, 3> f_vertex_side_, g_vertex_side_;
  std::array<std::optional<Feature>, 3> f_vertex_in_g_, g_vertex_in_f_;
};

}  // namespace

bool meet_coplanar_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                         PairIntersections& intersections) {
  return CoplanarMeeting(input, f, g).find(intersections);
}

bool meet_same_face(std::uint32_t f, const InputComplex::Indices& vf, std::uint32_t g, const InputComplex::Indices& vg,
                    PairIntersections& intersections) {
  const auto nowhere = ConstraintLine{};
  intersections.constraints.push_back({f, g, ConstraintKind::coplanar, nowhere, vf[0], vf[0]});
  intersections.constraints.push_back({g, f, ConstraintKind::coplanar, nowhere, vg[0], vg[0]});
  return true;
}

}  // namespace strata
