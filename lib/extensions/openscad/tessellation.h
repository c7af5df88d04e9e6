#pragma once
#include <cstdint>
#include <span>

#include "strata/mesh.h"

namespace strata::openscad {

/// The resolution of curves.
struct Resolution {
  double fn = 0;   ///< $fn: sides of a circle; 0: determined by the other two
  double fa = 12;  ///< $fa: least angle of a side in degrees, at least 0.01
  double fs = 2;   ///< $fs: least length of a side, at least 0.01
};

/// Sides of a circle of that radius: 3 for radii below 2^-20 and for a $fn that is not finite; otherwise $fn, rounded
/// up, at least 3, if it is positive; otherwise the smaller of 360 / $fa and circumference / $fs, rounded up, at least
/// 5. At most 2^31. Source: OpenSCAD User Manual, "$fa, $fs and $fn".
[[nodiscard]] std::uint32_t sides_of_circle(double radius, const Resolution& resolution);

/// Cosine and sine of an angle in [0, 360) degrees, computed from those of angles up to 45: exact where they are 0, 1/2
/// or 1, the nearest doubles to the square roots of 1/2 and 3/4, and equal up to signs wherever symmetry requires it.
struct Direction {
  double cosine = 1;
  double sine = 0;
};
[[nodiscard]] Direction direction(double degrees);

/// A regular polygon about the z axis with its first corner in direction x; with radius 0 a point.
struct Ring {
  double radius = 0;
  double z = 0;
};

/// The solid between the first and the last ring, each ring joined to the next. Rings are listed from below. Only the
/// first and the last may be points, but not both of two. Planar polygons are triangulated exactly, the quadrilaterals,
/// which rounding may bend, along the diagonal that goes up counter-clockwise. Closed, oriented outwards, without
/// degenerate triangles or crossings: the section at any height is a polygon whose corners are in order about the axis.
/// For this, radii are 0 or at least `least_radius`, heights increase, and there are 3 to 10^7 sides. O(corners).
[[nodiscard]] Mesh stack(std::span<const Ring> rings, std::uint32_t sides);
inline constexpr double least_radius = 1e-290;

}  // namespace strata::openscad
