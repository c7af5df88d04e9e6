#include "extensions/contact/interior_side.h"

#include <algorithm>

#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"

namespace strata::contact {

InteriorSides::InteriorSides(const Parts& parts, std::uint32_t a, std::uint32_t b) : parts_(parts) {
  const InputComplex& input = parts.input();
  const auto surface = [&](std::uint32_t part) {
    return Surface{part, std::vector<bool>(input.points(part).size()), std::vector<bool>(input.face_count(part))};
  };
  surfaces_ = {surface(a), surface(b)};
}

void InteriorSides::note_vertex(std::uint32_t vertex) {
  for (Surface& s : surfaces_) {
    const std::uint32_t first = parts_.input().first_vertex(s.part);
    if (vertex >= first && vertex - first < s.has_vertex_on.size()) s.has_vertex_on[vertex - first] = true;
  }
}

void InteriorSides::note(const PairIntersections& intersections) {
  const InputComplex& input = parts_.input();
  for (const Constraint& c : intersections.constraints) {
    if (c.kind == ConstraintKind::coplanar) continue;
    for (const PointId end : {c.tail, c.head})
      if (end < input.vertex_count()) note_vertex(end);
  }
  const Constraint& pair = intersections.constraints.front();
  if (share_area(input, intersections)) note_faces(pair.face, pair.other);
}

void InteriorSides::note_coincident_faces(std::uint32_t f, std::uint32_t g) {
  for (const std::uint32_t face : {f, g})
    for (const std::uint32_t v : parts_.input().face(face)) note_vertex(v);
  note_faces(f, g);
}

void InteriorSides::note_faces(std::uint32_t f, std::uint32_t g) {
  surfaces_[0].has_face_on[f - parts_.input().first_face(surfaces_[0].part)] = true;
  surfaces_[1].has_face_on[g - parts_.input().first_face(surfaces_[1].part)] = true;
}

bool InteriorSides::show_interference(const Monitor& monitor) const {
  return has_interior_side_inside(surfaces_[0], surfaces_[1], monitor) ||
         has_interior_side_inside(surfaces_[1], surfaces_[0], monitor);
}

/// Vertices that are not on the other surface connect the faces around them: there the interior sides are where the
/// vertex is.
bool InteriorSides::has_interior_side_inside(const Surface& surface, const Surface& other,
                                             const Monitor& monitor) const {
  const InputComplex& input = parts_.input();
  const auto points = input.points(surface.part);
  const auto faces = input.faces(surface.part);
  const Box& near = parts_.box(other.part);
  DisjointSets<std::uint32_t> sets(points.size());
  for (const auto& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = face[i], w = face[(i + 1) % 3];
      if (!surface.has_vertex_on[v] && !surface.has_vertex_on[w]) sets.unite(v, w);
    }
  std::vector<bool> is_known(points.size());
  const auto is_far = [&](std::uint32_t v) {
    return !box_of_vertex(input, input.first_vertex(surface.part) + v).overlaps(near);
  };
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (!surface.has_vertex_on[v] && is_far(v)) is_known[sets.find(v)] = true;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    monitor.check();
    const auto& face = faces[f];
    const auto is_free = [&](std::uint32_t v) { return !surface.has_vertex_on[v]; };
    const auto free = std::find_if(face.begin(), face.end(), is_free);
    if (free == face.end()) {
      if (!surface.has_face_on[f] && is_interior_side_inside(input.first_face(surface.part) + f, other.part))
        return true;
      continue;
    }
    const std::uint32_t piece = sets.find(*free);
    if (is_known[piece]) continue;
    is_known[piece] = true;
    const auto vertex = SymbolicPoint::input(input.first_vertex(surface.part) + *free);
    if (parts_.is_inside(make_point(input, vertex), other.part)) return true;
  }
  return false;
}

/// Decided at a point inside of the face that is in no plane of the other part's faces near it except the face's own
/// plane, in which these faces have no area in common with it. Such a plane contains at most two weighted points,
/// because these are on a conic.
bool InteriorSides::is_interior_side_inside(std::uint32_t face, std::uint32_t other) const {
  const InputComplex& input = parts_.input();
  const std::uint32_t part = input.operand_of_face(face);
  const auto corners = input.face(face);
  std::vector<std::uint32_t> planes;
  parts_.tree(other).for_each_near(box_of_face(input, part, face), [&](std::uint32_t g) {
    const auto v = input.face(g);
    const auto is_in_plane = [&](std::uint32_t w) { return orient3d(input, v[0], v[1], v[2], w) == Sign::zero; };
    if (!std::all_of(corners.begin(), corners.end(), is_in_plane)) planes.push_back(g);
    return true;
  });
  for (std::uint32_t weight = 1;; ++weight) {
    const Point p = make_point(input, SymbolicPoint::weighted(face, weight));
    const auto is_on = [&](std::uint32_t g) { return side_of_face(input, g, p) == Sign::zero; };
    if (std::none_of(planes.begin(), planes.end(), is_on)) return parts_.is_inside(p, other);
  }
}

}  // namespace strata::contact
