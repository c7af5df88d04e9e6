#include "core/kernel/ray_crossing.h"

#include <cstddef>

#include "core/kernel/predicates.h"

namespace strata {
namespace {

/// Winding number about q of a triangle's projection along x, as seen from positive x.
int winding_yz(const InputComplex& input, const std::array<Point, 3>& corners, const Point& q) {
  int winding = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = corners[k], &b = corners[(k + 1) % 3];
    const bool a_below = compare(input, 2, a, q) != Sign::positive, b_below = compare(input, 2, b, q) != Sign::positive;
    if (a_below && !b_below) winding += orient2d(input, {1, 2}, a, b, q) == Sign::positive;
    if (!a_below && b_below) winding -= orient2d(input, {1, 2}, b, a, q) == Sign::positive;
  }
  return winding;
}

}  // namespace

int crossing_along_x(const InputComplex& input, std::uint32_t face, const std::array<Point, 3>& corners,
                     const Point& q) {
  return crossing_along_x(input, face, winding_yz(input, corners, q), q);
}

int crossing_along_x(const InputComplex& input, std::uint32_t face, int winding, const Point& q) {
  if (winding == 0) return 0;
  return winding * to_int(side_of_face(input, face, q)) < 0 ? winding : 0;
}

// A point of the projected triangle is not on the left of one of its sides and on the right of another.
std::optional<int> winding_along_x(const std::array<const InputComplex::Coordinates*, 3>& corners,
                                   const BoundedPoint& q) {
  std::array<BoundedPoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {0, (*corners[i])[1], (*corners[i])[2]};
  int left_of = 0, right_of = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Sign> side = orientation_of(p[i], p[(i + 1) % 3], q, 1, 2).sign();
    left_of += side == Sign::positive;
    right_of += side == Sign::negative;
  }
  if (left_of > 0 && right_of > 0) return 0;
  if (left_of == 3) return 1;
  if (right_of == 3) return -1;
  return std::nullopt;
}

}  // namespace strata
