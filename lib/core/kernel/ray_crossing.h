#pragma once
#include <array>
#include <cstdint>

#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

namespace strata {

/// How a ray from q in the direction of x crosses a face: 1 where it leaves through the face's front, -1 where it
/// enters through it, 0 where it does not meet the face. The ray counts as moved by an infinitesimal distance towards
/// positive y, and by another one of higher order towards positive z, so that it meets no edge; q must not lie in the
/// face. O(1). Law: over the faces of a closed surface, the sum is the winding number of q.
[[nodiscard]] int crossing_along_x(const InputComplex& input, std::uint32_t face, const std::array<Point, 3>& corners,
                                   const Point& q);

/// True only where such a ray, wherever it starts along x, certainly passes beside a triangle with these corners. O(1),
/// in doubles.
[[nodiscard]] bool certainly_passes_beside(const std::array<const InputComplex::Coordinates*, 3>& corners,
                                           const BoundedPoint& q);

}  // namespace strata
