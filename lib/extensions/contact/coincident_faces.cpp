#include "extensions/contact/coincident_faces.h"

#include <algorithm>
#include <span>

#include "core/overlap/filtered_face.h"

namespace strata::contact {
namespace {

using Indices = InputComplex::Indices;

bool has(const Indices& face, std::uint32_t v) { return face[0] == v || face[1] == v || face[2] == v; }

/// Faces of a part, by local numbers, of which every corner is a double in a box.
std::vector<std::uint32_t> faces_within(const Parts& parts, std::uint32_t part, const Box& box) {
  const InputComplex& input = parts.input();
  const auto points = input.points(part);
  const std::uint32_t first = input.first_vertex(part);
  std::vector<std::uint32_t> found;
  parts.tree(part).for_each_near(box, [&](std::uint32_t face) {
    const std::uint32_t f = face - input.first_face(part);
    const auto& corners = input.faces(part)[f];
    const auto is_within = [&](std::uint32_t v) {
      Box place;
      place.include(points[v]);
      return place.overlaps(box) && input.has_doubles(first + v);
    };
    if (std::all_of(corners.begin(), corners.end(), is_within)) found.push_back(f);
    return true;
  });
  return found;
}

/// Finds vertices of a part by position; if there are several, one of them.
class VerticesByPlace {
 public:
  VerticesByPlace(const InputComplex& input, std::uint32_t part, const std::vector<std::uint32_t>& faces)
      : points_(input.points(part)) {
    for (const std::uint32_t f : faces)
      for (const std::uint32_t v : input.faces(part)[f]) vertices_.push_back(v);
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [&](std::uint32_t v, std::uint32_t w) { return points_[v] < points_[w]; });
  }
  [[nodiscard]] std::uint32_t find(const InputComplex::Coordinates& place) const {
    const auto v =
        std::lower_bound(vertices_.begin(), vertices_.end(), place,
                         [&](std::uint32_t w, const InputComplex::Coordinates& p) { return points_[w] < p; });
    return v != vertices_.end() && points_[*v] == place ? *v : Twins::none;
  }

 private:
  std::span<const InputComplex::Coordinates> points_;
  std::vector<std::uint32_t> vertices_;
};

/// A face rotated so that its lowest corner is first, or the mirror image of that.
struct NormalizedFace {
  explicit NormalizedFace(const Indices& vertices, std::uint32_t number = 0) : corners(vertices), face(number) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  [[nodiscard]] NormalizedFace mirrored() const { return NormalizedFace({corners[0], corners[2], corners[1]}); }
  friend bool operator<(const NormalizedFace& f, const NormalizedFace& g) { return f.corners < g.corners; }

  Indices corners;
  std::uint32_t face;
};

}  // namespace

Twins::Twins(const Parts& parts, std::uint32_t a, std::uint32_t b) : input_(parts.input()), parts_{a, b} {
  for (std::size_t i = 0; i < 2; ++i) partner_[i].assign(input_.face_count(parts_[i]), none);
  const Box box = parts.common_box(a, b);
  const std::vector<std::uint32_t> of_a = faces_within(parts, a, box), of_b = faces_within(parts, b, box);
  const VerticesByPlace vertices(input_, b, of_b);
  std::vector<NormalizedFace> faces;
  for (const std::uint32_t g : of_b) faces.emplace_back(input_.faces(b)[g], g);
  std::sort(faces.begin(), faces.end());
  const auto points = input_.points(a);
  std::vector<std::uint32_t> same(points.size(), none);  // vertices of b at the positions of a's
  std::vector<bool> is_known(points.size());
  for (const std::uint32_t f : of_a) {
    const auto& corners = input_.faces(a)[f];
    for (const std::uint32_t v : corners) {
      if (!is_known[v]) same[v] = vertices.find(points[v]);
      is_known[v] = true;
    }
    const Indices there{same[corners[0]], same[corners[1]], same[corners[2]]};
    if (has(there, none)) continue;
    for (const bool is_mirrored : {true, false}) {
      const NormalizedFace face = is_mirrored ? NormalizedFace(there).mirrored() : NormalizedFace(there);
      const auto partner = std::lower_bound(faces.begin(), faces.end(), face);
      if (partner == faces.end() || partner->corners != face.corners) continue;
      pairs_.push_back({input_.first_face(a) + f, input_.first_face(b) + partner->face, !is_mirrored});
      partner_[0][f] = partner->face;
      partner_[1][partner->face] = f;
      break;
    }
  }
}

bool Twins::tell(std::uint32_t f, std::uint32_t g) const {
  const std::uint32_t in_a = f - input_.first_face(parts_[0]), in_b = g - input_.first_face(parts_[1]);
  const std::uint32_t of_f = partner_[0][in_a], of_g = partner_[1][in_b];
  return (of_f != none && meet_in_corners(parts_[1], of_f, in_b)) ||
         (of_g != none && meet_in_corners(parts_[0], of_g, in_a));
}

/// True when doubles prove that faces of one part are equal, or have only corners and edges in common.
bool Twins::meet_in_corners(std::uint32_t part, std::uint32_t face, std::uint32_t other) const {
  if (face == other) return true;
  const auto &corners = input_.faces(part)[face], &others = input_.faces(part)[other];
  if (std::none_of(others.begin(), others.end(), [&](std::uint32_t v) { return has(corners, v); })) return false;
  const std::uint32_t first = input_.first_face(part);
  const FilteredFace f(input_, part, first + face), g(input_, part, first + other);
  return f.is_beside(g, f.sides_of(g)) || g.is_beside(f, g.sides_of(f)) || f.is_off(g) || g.is_off(f);
}

}  // namespace strata::contact
