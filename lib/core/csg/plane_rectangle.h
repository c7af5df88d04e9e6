#pragma once
#include <cstddef>

#include "strata/mesh.h"
#include "strata/plane.h"
#include "strata/solid.h"

namespace strata {

/// The first axis along which the normal is longest. Throws std::invalid_argument for a normal 0.
[[nodiscard]] std::size_t main_axis(const Plane& plane);

/// The sum, which is finite. Throws std::overflow_error where it would not be.
[[nodiscard]] double finite_sum(double a, double b);

/// How far to go beyond a box: its longest side, and more than an ulp of its coordinates; 1 for a point at the origin.
[[nodiscard]] double reach_of(const BoundingBox& box);

/// Four points of a plane, around all points of it in a box and away from them: counter-clockwise as seen from the end
/// of the axis, along which the normal must not be 0. Two triangles. Throws std::overflow_error.
[[nodiscard]] ExactMesh rectangle_in(const Plane& plane, std::size_t axis, const BoundingBox& box);

}  // namespace strata
