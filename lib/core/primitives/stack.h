#pragma once
#include <cstdint>
#include <span>

#include "strata/mesh.h"

namespace strata {

/// A regular polygon about the z axis with its first corner in direction x; with radius 0 a point.
struct Ring {
  double radius = 0;
  double z = 0;
};

/// The solid between the first and the last ring, each ring joined to the next. Rings come from below; the first and
/// the last alone may be points, but not both of two. Planar polygons are divided exactly, the quadrilaterals, which
/// rounding may bend, along the diagonal that leads up counter-clockwise. Closed, oriented outwards, without degenerate
/// triangles or crossings: the section at any height is a polygon whose corners turn about the axis. For this radii are
/// 0 or at least `least_radius`, heights increase, and there are from 3 up to 10^7 sides. O(corners).
[[nodiscard]] Mesh stack(std::span<const Ring> rings, std::uint32_t sides);
inline constexpr double least_radius = 1e-290;

}  // namespace strata
