#include "strata/contact/separation.h"

#include <algorithm>
#include <array>
#include <optional>

#include "strata/kernel/predicates.h"
#include "strata/overlap/filtered_face.h"

namespace strata::contact {
namespace {

/// One side of a face's plane, within a box.
struct HalfBox {
  const FilteredFace& face;
  Sign side;
  Box box;
};

/// Sides of a plane on which vertices are. Remembers vertices in the plane, which are the ones that take long; those of
/// neighbouring faces come soon after one another.
class Sides {
 public:
  Sides(const Carriers& carriers, const FilteredFace& plane) : carriers_(carriers), plane_(plane) {
    in_plane_.fill(~0u);
  }

  /// True when some vertex of a face is strictly on a side.
  [[nodiscard]] bool has_vertex(const FilteredFace& face, Sign side) {
    const Signs quick = plane_.sides_of(face);
    for (std::size_t i = 0; i < 3; ++i)
      if (quick[i] == side) return true;
    for (std::size_t i = 0; i < 3; ++i)
      if (quick[i] == Sign::zero && exact_side(face.vertices[i]) == side) return true;
    return false;
  }

 private:
  [[nodiscard]] Sign exact_side(std::uint32_t v) {
    std::uint32_t& known = in_plane_[v % in_plane_.size()];
    if (known == v) return Sign::zero;
    const auto& p = plane_.vertices;
    const Sign s = orient3d(carriers_, p[0], p[1], p[2], v);
    if (s == Sign::zero) known = v;
    return s;
  }

  const Carriers& carriers_;
  const FilteredFace& plane_;
  std::array<std::uint32_t, 512> in_plane_;
};

/// The side of a plane on which all of a box certainly is; zero when that does not show.
Sign side_of_box(const FilteredFace& plane, const Box& box) {
  BoundedPoint all;
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = box.lower[i] / 2 + box.upper[i] / 2;
    all[i] = {middle, std::max(box.upper[i] - middle, middle - box.lower[i]) * Bounded::slack + Bounded::underflow};
  }
  if (plane.is_exact) return static_cast<Sign>(plane.plane.side_within(all));
  return dot<Bounded>(plane.rational_plane.normal, all - plane.rational_plane.at).sign().value_or(Sign::zero);
}

/// True when no face of a part that comes near the box reaches into the half.
bool is_clear_of(const Parts& parts, std::uint32_t part, const HalfBox& half) {
  const Carriers& carriers = parts.carriers();
  Sides sides(carriers, half.face);
  const auto may_reach = [&](const Box& box) {
    return box.overlaps(half.box) && side_of_box(half.face, box) != -half.side;
  };
  return parts.tree(part).for_each_in(may_reach, [&](std::uint32_t f) {
    if (!box_of_face(carriers, part, f).overlaps(half.box)) return true;
    return !sides.has_vertex(FilteredFace(carriers, part, f), half.side);
  });
}

/// A corner of the box strictly in the half; none: no point of the box is, since a plane leaves a box at a corner.
std::optional<Carriers::Coordinates> corner_in(const Carriers& carriers, const HalfBox& half) {
  for (std::size_t number = 0; number < 8; ++number) {
    Carriers::Coordinates corner{};
    for (std::size_t i = 0; i < 3; ++i) corner[i] = (number >> i & 1) != 0 ? half.box.upper[i] : half.box.lower[i];
    if (side_of_face(carriers, half.face.face, Point::free(corner)) == half.side) return corner;
  }
  return std::nullopt;
}

/// True when a part has nothing of the half: its surface keeps clear, and some point there is outside of it.
bool has_nothing_of(const Parts& parts, std::uint32_t part, const HalfBox& half) {
  if (!is_clear_of(parts, part, half)) return false;
  const auto corner = corner_in(parts.carriers(), half);
  return !corner || !parts.is_inside(Point::free(*corner), part);
}

}  // namespace

bool separates(const Parts& parts, std::uint32_t face, std::uint32_t a, std::uint32_t b) {
  const FilteredFace plane(parts.carriers(), face);
  const Box box = parts.common_box(a, b);
  return has_nothing_of(parts, a, {plane, Sign::positive, box}) &&
         has_nothing_of(parts, b, {plane, Sign::negative, box});
}

}  // namespace strata::contact
