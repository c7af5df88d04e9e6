#pragma once
#include "core/kernel/predicates.h"

namespace strata {

/// Is q, a point of the plane of a face, in the closed face?
[[nodiscard]] inline bool holds_point_of_plane(const InputComplex& input, std::uint32_t face, const Point& q) {
  const auto v = input.face(face);
  const Projection projection = projection_of(input, face);
  const auto corner = [&](std::size_t i) { return make_point(input, SymbolicPoint::input(v[i])); };
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(input, projection, corner(i), corner((i + 1) % 3), q) == Sign::negative) return false;
  return true;
}

/// Is q in the closed face? Bounds are tested first.
[[nodiscard]] inline bool is_on_closed_face(const InputComplex& input, std::uint32_t face, const Point& q) {
  const auto v = input.face(face);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = q.at[axis].lower(), high = q.at[axis].upper();
    int below = 0, above = 0;
    for (const std::uint32_t i : v) {
      // The nearest doubles are in the order of the exact positions, or equal.
      below += input.vertex(i)[axis] < low;
      above += input.vertex(i)[axis] > high;
    }
    const bool exact = !input.has_rationals();
    if (exact && (below == 3 || above == 3)) return false;
  }
  return side_of_face(input, face, q) == Sign::zero && holds_point_of_plane(input, face, q);
}

}  // namespace strata
