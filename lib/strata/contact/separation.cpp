#include "strata/contact/separation.h"

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

Sign side(const Carriers& carriers, const FilteredFace& plane, const FilteredFace& other, const Signs& quick,
          std::size_t i) {
  if (quick[i] != Sign::zero) return quick[i];
  const auto& v = plane.vertices;
  return orient3d(carriers, v[0], v[1], v[2], other.vertices[i]);
}

/// True when no face of a part that comes near the box reaches into the half.
bool is_clear_of(const Parts& parts, std::uint32_t part, const HalfBox& half) {
  const Carriers& carriers = parts.carriers();
  return parts.tree(part).for_each_near(half.box, [&](std::uint32_t f) {
    if (!box_of_face(carriers, part, f).overlaps(half.box)) return true;
    const FilteredFace face(carriers, part, f);
    const Signs quick = half.face.sides_of(face);
    for (std::size_t i = 0; i < 3; ++i)
      if (side(carriers, half.face, face, quick, i) == half.side) return false;
    return true;
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
