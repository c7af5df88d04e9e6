#pragma once
#include <cstdint>
#include <span>

#include "strata/mesh.h"

namespace strata::openscad {

/// How finely curves are divided.
struct Resolution {
  double fn = 0;   ///< $fn: sides of a circle; 0: as the other two have it
  double fa = 12;  ///< $fa: least angle of a side in degrees, at least 0.01
  double fs = 2;   ///< $fs: least length of a side, at least 0.01
};

/// Sides of a circle of that radius: 3 for radii below 2^-20 and for a $fn that is not finite; else $fn, rounded up, at
/// least 3, if it is positive; else the fewest, but at least 5, that no side is both narrower than $fa and shorter than
/// $fs. Cut off at 2^31. Source: OpenSCAD User Manual, "$fa, $fs and $fn".
[[nodiscard]] std::uint32_t sides_of_circle(double radius, const Resolution& resolution);

/// Cosine and sine of an angle in [0, 360) degrees, from those of angles up to 45: exact where they are 0, 1/2 or 1,
/// the nearest doubles to the square roots of 1/2 and 3/4, and equal up to signs wherever symmetry says so.
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

/// The solid between the first and the last ring, each ring joined to the next. Rings come from below; the first and
/// the last alone may be points, but not both of two. Planar polygons are divided exactly, the quadrilaterals, which
/// rounding may bend, along the diagonal that leads up counter-clockwise. Closed, oriented outwards, without degenerate
/// triangles or crossings: the section at any height is a polygon whose corners turn about the axis. For this radii are
/// 0 or at least `least_radius`, heights increase, and there are from 3 up to 10^7 sides. O(corners).
[[nodiscard]] Mesh stack(std::span<const Ring> rings, std::uint32_t sides);
inline constexpr double least_radius = 1e-290;

}  // namespace strata::openscad
