#include "extensions/contact/lining.h"

#include <algorithm>

#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"

namespace strata::contact {

Linings::Linings(const Parts& parts, std::uint32_t a, std::uint32_t b) : parts_(parts) {
  const Carriers& carriers = parts.carriers();
  const auto surface = [&](std::uint32_t part) {
    return Surface{part, std::vector<bool>(carriers.points(part).size()), std::vector<bool>(carriers.face_count(part))};
  };
  surfaces_ = {surface(a), surface(b)};
}

void Linings::note_vertex(std::uint32_t vertex) {
  for (Surface& s : surfaces_) {
    const std::uint32_t first = parts_.carriers().first_vertex(s.part);
    if (vertex >= first && vertex - first < s.has_vertex_on.size()) s.has_vertex_on[vertex - first] = true;
  }
}

void Linings::note(const Meetings& meetings) {
  const Carriers& carriers = parts_.carriers();
  for (const Constraint& c : meetings.constraints) {
    if (c.kind == ConstraintKind::coplanar) continue;
    for (const PointId end : {c.tail, c.head})
      if (end < carriers.vertex_count()) note_vertex(end);
  }
  const Constraint& pair = meetings.constraints.front();
  if (share_area(carriers, meetings)) note_faces(pair.face, pair.other);
}

void Linings::note_twins(std::uint32_t f, std::uint32_t g) {
  for (const std::uint32_t face : {f, g})
    for (const std::uint32_t v : parts_.carriers().face(face)) note_vertex(v);
  note_faces(f, g);
}

void Linings::note_faces(std::uint32_t f, std::uint32_t g) {
  surfaces_[0].has_face_on[f - parts_.carriers().first_face(surfaces_[0].part)] = true;
  surfaces_[1].has_face_on[g - parts_.carriers().first_face(surfaces_[1].part)] = true;
}

bool Linings::show_interference() const {
  return has_lining_inside(surfaces_[0], surfaces_[1]) || has_lining_inside(surfaces_[1], surfaces_[0]);
}

/// Vertices that are not on the other surface join the faces around them: there the linings are where the vertex is.
bool Linings::has_lining_inside(const Surface& surface, const Surface& other) const {
  const Carriers& carriers = parts_.carriers();
  const auto points = carriers.points(surface.part);
  const auto faces = carriers.faces(surface.part);
  const Box& near = parts_.box(other.part);
  DisjointSets<std::uint32_t> sets(points.size());
  for (const auto& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = face[i], w = face[(i + 1) % 3];
      if (!surface.has_vertex_on[v] && !surface.has_vertex_on[w]) sets.unite(v, w);
    }
  std::vector<bool> is_known(points.size());
  const auto is_far = [&](std::uint32_t v) {
    return !box_of_vertex(carriers, carriers.first_vertex(surface.part) + v).overlaps(near);
  };
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (!surface.has_vertex_on[v] && is_far(v)) is_known[sets.find(v)] = true;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    const auto is_free = [&](std::uint32_t v) { return !surface.has_vertex_on[v]; };
    const auto free = std::find_if(face.begin(), face.end(), is_free);
    if (free == face.end()) {
      if (!surface.has_face_on[f] && is_lining_inside(carriers.first_face(surface.part) + f, other.part)) return true;
      continue;
    }
    const std::uint32_t piece = sets.find(*free);
    if (is_known[piece]) continue;
    is_known[piece] = true;
    const auto vertex = PointName::input(carriers.first_vertex(surface.part) + *free);
    if (parts_.is_inside(make_point(carriers, vertex), other.part)) return true;
  }
  return false;
}

/// By a point inside of the face that is in no plane of the other part's faces near it but the face's own, of which
/// they have no area. Such a plane holds two weighted points at most, for these are on a conic.
bool Linings::is_lining_inside(std::uint32_t face, std::uint32_t other) const {
  const Carriers& carriers = parts_.carriers();
  const std::uint32_t part = carriers.operand_of_face(face);
  const auto corners = carriers.face(face);
  std::vector<std::uint32_t> planes;
  parts_.tree(other).for_each_near(box_of_face(carriers, part, face), [&](std::uint32_t g) {
    const auto v = carriers.face(g);
    const auto is_in_plane = [&](std::uint32_t w) { return orient3d(carriers, v[0], v[1], v[2], w) == Sign::zero; };
    if (!std::all_of(corners.begin(), corners.end(), is_in_plane)) planes.push_back(g);
    return true;
  });
  for (std::uint32_t weight = 1;; ++weight) {
    const Point p = make_point(carriers, PointName::weighted(face, weight));
    const auto is_on = [&](std::uint32_t g) { return side_of_face(carriers, g, p) == Sign::zero; };
    if (std::none_of(planes.begin(), planes.end(), is_on)) return parts_.is_inside(p, other);
  }
}

}  // namespace strata::contact
