#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

namespace strata {

/// How a ray from q in the direction of x crosses a face: 1 where it leaves through the face's front, -1 where it
/// enters through it, 0 where it does not meet the face. The ray counts as moved by an infinitesimal distance towards
/// positive y, and by another one of higher order towards positive z, so that it meets no edge; q must not lie in the
/// face. O(1). Law: over the faces of a closed surface, the sum is the winding number of q.
[[nodiscard]] int crossing_along_x(const InputComplex& input, std::uint32_t face, const std::array<Point, 3>& corners,
                                   const Point& q);

/// Winding number about q of a triangle with these corners, as seen from positive x: 0 where such a ray passes beside
/// it, wherever along x it starts. nullopt where doubles do not tell. O(1).
[[nodiscard]] std::optional<int> winding_along_x(const std::array<const InputComplex::Coordinates*, 3>& corners,
                                                 const BoundedPoint& q);
/// `crossing_along_x` of a face with this winding number.
[[nodiscard]] int crossing_along_x(const InputComplex& input, std::uint32_t face, int winding, const Point& q);

}  // namespace strata
