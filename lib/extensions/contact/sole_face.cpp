#include "extensions/contact/sole_face.h"

#include <optional>

#include "extensions/contact/convex_polygon.h"

namespace strata::contact {
namespace {

RationalPoint middle_of(const InputComplex& input, const CommonPoints& points) {
  RationalPoint sum;
  for (const SymbolicPoint& name : points) {
    const RationalPoint p = exact_position(input, make_point(input, name));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i];
  }
  for (Rational& x : sum) x /= points.size();
  return sum;
}

ConvexPolygon triangle(const InputComplex& input, std::uint32_t face) {
  std::vector<RationalPoint> corners;
  for (const std::uint32_t v : input.face(face))
    corners.push_back(exact_position(input, make_point(input, SymbolicPoint::input(v))));
  return ConvexPolygon(std::move(corners));
}

/// True when doubles prove that no point of `other` is in the interior of `face`.
bool is_beside(const FilteredFace& face, const FilteredFace& other) {
  return face.is_beside(other, face.sides_of(other)) || face.is_off(other);
}

}  // namespace

bool is_sole_face(const Parts& parts, const FilteredFace& face, const CommonPoints& points) {
  const InputComplex& input = parts.input();
  const std::uint32_t part = input.operand_of_face(face.face);
  Box near;  // contains all points, and so their middle
  for (const SymbolicPoint& name : points) {
    const BoundedPoint p = make_point(input, name).at;
    near.include(InputComplex::Coordinates{p[0].lower(), p[1].lower(), p[2].lower()});
    near.include(InputComplex::Coordinates{p[0].upper(), p[1].upper(), p[2].upper()});
  }
  std::optional<RationalPoint> middle;
  return parts.tree(part).for_each_near(near, [&](std::uint32_t f) {
    if (f == face.face || !box_of_face(input, part, f).overlaps(near)) return true;
    if (is_beside(face, FilteredFace(input, part, f))) return true;
    if (!middle) middle = middle_of(input, points);
    return !triangle(input, f).has(*middle);
  });
}

}  // namespace strata::contact
