#include "extensions/contact/separation.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/kernel/approximation.h"
#include "core/kernel/predicates.h"
#include "core/overlap/filtered_face.h"

namespace strata::contact {
namespace {

/// One side of a face's plane, within a box.
struct HalfBox {
  const FilteredFace& face;
  Sign side;
  Box box;
};

/// The side of a plane on which a point within bounds certainly is; zero when that is not certain.
Sign side_of(const FilteredFace& plane, const BoundedPoint& p) {
  if (plane.is_exact) return static_cast<Sign>(plane.plane.side_within(p));
  return dot<Bounded>(plane.rational_plane.normal, p - plane.rational_plane.at).sign().value_or(Sign::zero);
}

/// The same for all of a box.
Sign side_of_box(const FilteredFace& plane, const Box& box) {
  BoundedPoint all;
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = box.lower[i] / 2 + box.upper[i] / 2;
    all[i] = {middle, std::max(box.upper[i] - middle, middle - box.lower[i]) * Bounded::slack + Bounded::underflow};
  }
  return side_of(plane, all);
}

/// Sides of a plane on which a part's vertices are. Caches some of them: those of neighbouring faces are needed soon
/// after one another, and vertices in the plane are expensive.
class Sides {
 public:
  Sides(const Parts& parts, std::uint32_t part, const FilteredFace& plane)
      : input_(parts.input()),
        plane_(plane),
        points_(input_.points(part)),
        faces_(input_.faces(part)),
        first_vertex_(input_.first_vertex(part)),
        first_face_(input_.first_face(part)) {}

  /// True when some vertex of a face is strictly on a side.
  [[nodiscard]] bool has_vertex(std::uint32_t face, Sign side) {
    const auto& f = faces_[face - first_face_];
    return of(f[0]) == side || of(f[1]) == side || of(f[2]) == side;
  }

 private:
  struct Known {
    std::uint32_t vertex = ~0u;
    Sign side = Sign::zero;
  };

  Sign of(std::uint32_t vertex) {
    Known& known = known_[vertex % known_.size()];
    if (known.vertex != vertex) known = {vertex, find(vertex)};
    return known.side;
  }
  [[nodiscard]] Sign find(std::uint32_t vertex) const {
    const std::uint32_t v = first_vertex_ + vertex;
    const auto& at = points_[vertex];
    const Sign quick = input_.has_doubles(v) ? side_of(plane_, {at[0], at[1], at[2]})
                                             : side_of(plane_, approximate_vertex<Bounded>(input_, v));
    if (quick != Sign::zero) return quick;
    const auto& p = plane_.vertices;
    return orient3d(input_, p[0], p[1], p[2], v);
  }

  const InputComplex& input_;
  const FilteredFace& plane_;
  std::span<const InputComplex::Coordinates> points_;
  std::span<const InputComplex::Indices> faces_;
  std::uint32_t first_vertex_, first_face_;
  std::array<Known, 512> known_;
};

/// True when no face of a part that comes near the box reaches into the half.
bool is_clear_of(const Parts& parts, std::uint32_t part, const HalfBox& half) {
  const InputComplex& input = parts.input();
  Sides sides(parts, part, half.face);
  const auto may_reach = [&](const Box& box) {
    return box.overlaps(half.box) && side_of_box(half.face, box) != -half.side;
  };
  return parts.tree(part).for_each_in(may_reach, [&](std::uint32_t f) {
    return !sides.has_vertex(f, half.side) || !box_of_face(input, part, f).overlaps(half.box);
  });
}

/// A corner of the box strictly in the half; nullopt: no point of the box is, because a linear form is largest at a
/// corner.
std::optional<InputComplex::Coordinates> corner_in(const InputComplex& input, const HalfBox& half) {
  for (std::size_t number = 0; number < 8; ++number) {
    InputComplex::Coordinates corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = (number >> i & 1) != 0 ? half.box.upper[i] : half.box.lower[i];
    if (side_of_face(input, half.face.face, Point::free(corner)) == half.side) return corner;
  }
  return std::nullopt;
}

/// True when a part has nothing of the half: its surface does not reach it, and some point there is outside of the
/// part.
bool has_nothing_of(const Parts& parts, std::uint32_t part, const HalfBox& half) {
  if (!is_clear_of(parts, part, half)) return false;
  const auto corner = corner_in(parts.input(), half);
  return !corner || !parts.is_inside(Point::free(*corner), part);
}

}  // namespace

bool separates(const Parts& parts, std::uint32_t face, std::uint32_t a, std::uint32_t b) {
  const FilteredFace plane(parts.input(), face);
  const Box box = parts.common_box(a, b);
  return has_nothing_of(parts, a, {plane, Sign::positive, box}) &&
         has_nothing_of(parts, b, {plane, Sign::negative, box});
}

}  // namespace strata::contact
