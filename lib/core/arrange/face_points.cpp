#include "core/arrange/face_points.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/arrange/triangle_index.h"
#include "core/kernel/known_planes.h"

namespace strata {

using namespace triangle_index;

namespace {

constexpr std::size_t few = 32;

/// The vertices that are known to lie in the plane of a face.
class PlaneOfFace {
 public:
  PlaneOfFace(const InputComplex& input, std::uint32_t face) : input_(input), face_(face), corners_(input.face(face)) {}

  /// A positive answer is certain: an edge or a face through the point lies in the plane.
  [[nodiscard]] bool has(const SymbolicPoint& name) const {
    const auto& id = name.id;
    switch (name.kind) {
      case SymbolicPoint::Kind::input:
        return has_vertex(id[0]);
      case SymbolicPoint::Kind::edge_edge:
        return has_edge(id[0], id[1]) || has_edge(id[2], id[3]);
      case SymbolicPoint::Kind::edge_face:
        return has_face(id[2]) || has_edge(id[0], id[1]);
      case SymbolicPoint::Kind::three_faces:
        return has_face(id[0]) || has_face(id[1]) || has_face(id[2]);
      case SymbolicPoint::Kind::weighted:
      case SymbolicPoint::Kind::free:
        return false;
    }
    return false;
  }

 private:
  [[nodiscard]] bool has_vertex(std::uint32_t v) const {
    return v == corners_[0] || v == corners_[1] || v == corners_[2] ||
           orient3d(input_, corners_[0], corners_[1], corners_[2], v) == Sign::zero;
  }
  [[nodiscard]] bool has_edge(std::uint32_t v, std::uint32_t w) const { return has_vertex(v) && has_vertex(w); }
  [[nodiscard]] bool has_face(std::uint32_t face) const {
    if (face == face_) return true;
    const auto v = input_.face(face);
    return has_vertex(v[0]) && has_vertex(v[1]) && has_vertex(v[2]);
  }

  const InputComplex& input_;
  std::uint32_t face_;
  InputComplex::Indices corners_;
};

}  // namespace

void FacePoints::start(std::uint32_t face) {
  face_ = face;
  corners_ = input_.face(face);
  projection_ = projection_of(input_, face);
  points_.clear();
  ids_.clear();
  known_.clear();
  if (!many_known_.empty()) many_known_ = {};  // its buckets, as many as the largest face needed, would all be cleared
  for (const std::uint32_t v : corners_) add(v);
}

std::int32_t FacePoints::add(PointId id) {
  const std::int32_t v = add(table_.point(id));
  number(v, id);
  return v;
}

void FacePoints::number(std::int32_t v, PointId id) {
  ids_[at(v)] = id;
  remember(id, v);
}

std::int32_t FacePoints::add(const Point& point) {
  points_.push_back(point);
  ids_.push_back(unnumbered);
  return size() - 1;
}

void FacePoints::remember(PointId id, std::int32_t known) {
  known_.emplace_back(id, known);
  if (known_.size() == few + 1) many_known_.insert(known_.begin(), known_.end());
  if (known_.size() > few + 1) many_known_.emplace(id, known);
}

std::int32_t FacePoints::find(PointId id) const {
  if (known_.size() <= few) {
    for (const auto& [i, v] : known_)
      if (i == id) return v;
    return -1;
  }
  const auto found = many_known_.find(id);
  return found == many_known_.end() ? -1 : found->second;
}

void FacePoints::drop_last() {
  points_.pop_back();
  ids_.pop_back();
}

Sign FacePoints::orientation(std::int32_t a, std::int32_t b, std::int32_t c) const {
  if (a == b || b == c || a == c) return Sign::zero;
  const Point &p = points_[at(a)], &q = points_[at(b)], &r = points_[at(c)];
  if (const auto sign = filtered_orient2d(projection_, p, q, r)) return *sign;
  if (collinear_by_name(p, q, r)) return Sign::zero;
  if (const auto sign = refined_orient2d(projection_, p, q, r)) return *sign;
  if (collinear_by_edges(p, q, r) || collinear_by_planes(p, q, r) || collinear_by_faces(p, q, r)) return Sign::zero;
  return exact_orient2d(input_, projection_, p, q, r);
}

/// Three points of this face are collinear when they also lie in another source plane.
bool FacePoints::collinear_by_planes(const Point& p, const Point& q, const Point& r) const {
  if (!input_.has_planes()) return false;
  const KnownPlanes of_p(input_, p), of_q(input_, q), of_r(input_, r);
  for (const SourcePlane* plane : of_p.list())
    if (of_q.has(plane) && of_r.has(plane) && is_surely_other_plane(*plane)) return true;
  return false;
}

bool FacePoints::is_surely_other_plane(const SourcePlane& plane) const {
  for (std::int32_t k = 0; k < 3; ++k) {
    const auto side = dot<Bounded>(plane.bounded_normal(), points_[at(k)].at - plane.bounded_at()).sign();
    if (side && *side != Sign::zero) return true;
  }
  return false;
}

bool FacePoints::are_on_edge(int k, std::int32_t a, std::int32_t b) const {
  const std::uint32_t from = corners_[at(k)], to = corners_[at(next(k))];
  return named_on_edge(points_[at(a)].name, from, to) && named_on_edge(points_[at(b)].name, from, to);
}

bool FacePoints::leaves_plane(const InputComplex::Indices& vertices) const {
  for (const std::uint32_t v : vertices)
    if (orient3d(input_, corners_[0], corners_[1], corners_[2], v) != Sign::zero) return true;
  return false;
}

/// Three points of this face are collinear when they lie on one edge, or on a face in another plane.
bool FacePoints::collinear_by_name(const Point& p, const Point& q, const Point& r) const {
  const auto all_on_edge = [&](std::uint32_t a, std::uint32_t b) {
    return named_on_edge(p.name, a, b) && named_on_edge(q.name, a, b) && named_on_edge(r.name, a, b);
  };
  const auto all_on_face = [&](std::uint32_t g) {
    if (g == face_) return false;
    const auto v = input_.face(g);
    return named_on_face(p.name, g, v) && named_on_face(q.name, g, v) && named_on_face(r.name, g, v) && leaves_plane(v);
  };
  for (int i = 0; i < 3; ++i)
    if (all_on_edge(corners_[at(i)], corners_[at(next(i))])) return true;
  for (const Point* x : {&p, &q, &r}) {
    const auto& id = x->name.id;
    switch (x->name.kind) {
      case SymbolicPoint::Kind::edge_edge:
        if (all_on_edge(id[0], id[1]) || all_on_edge(id[2], id[3])) return true;
        break;
      case SymbolicPoint::Kind::edge_face:
        if (all_on_edge(id[0], id[1]) || all_on_face(id[2])) return true;
        break;
      case SymbolicPoint::Kind::three_faces:
        if (all_on_face(id[0]) || all_on_face(id[1]) || all_on_face(id[2])) return true;
        break;
      case SymbolicPoint::Kind::input:
      case SymbolicPoint::Kind::weighted:
      case SymbolicPoint::Kind::free:
        break;
    }
  }
  return false;
}

/// Three points where edges cross this face are collinear when the edges lie in one plane. It is not the plane of the
/// face, which they cross. The test is used for edges with four vertices in all, such as neighbouring sides of a
/// quadrilateral and its diagonal. It has degree 3; the orientation test has degree 11.
bool FacePoints::collinear_by_edges(const Point& p, const Point& q, const Point& r) const {
  std::array<std::uint32_t, 6> ends{};
  std::size_t count = 0;
  for (const Point* x : {&p, &q, &r}) {
    if (x->name.kind != SymbolicPoint::Kind::edge_face || x->name.id[2] != face_) return false;
    ends[count++] = x->name.id[0];
    ends[count++] = x->name.id[1];
  }
  std::sort(ends.begin(), ends.end());
  if (std::unique(ends.begin(), ends.end()) != ends.begin() + 4) return false;
  return orient3d(input_, ends[0], ends[1], ends[2], ends[3]) == Sign::zero;
}

/// Three points of this face are collinear when they also lie in the plane of another face, as where edges of coplanar
/// faces cross this one. Degree 3; the orientation test has degree 11.
bool FacePoints::collinear_by_faces(const Point& p, const Point& q, const Point& r) const {
  for (const Point* x : {&p, &q, &r}) {
    const std::uint32_t g = x->name.id[2];
    if (x->name.kind != SymbolicPoint::Kind::edge_face || g == face_) continue;
    const PlaneOfFace plane(input_, g);
    if (plane.has(p.name) && plane.has(q.name) && plane.has(r.name)) return leaves_plane(input_.face(g));
  }
  return false;
}

}  // namespace strata
