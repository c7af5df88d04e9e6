#pragma once
#include <cstdint>
#include <string_view>

#include "extensions/openscad/arguments.h"

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

/// The arguments $fn, $fa and $fs. Throws CsgError for $fa and $fs that are no numbers, and for $fe.
[[nodiscard]] Resolution resolution_of(const Arguments& arguments);

/// A radius, or half of a diameter, which has precedence.
[[nodiscard]] double radius_of(const Arguments& arguments, std::string_view diameter, std::string_view radius,
                               double otherwise);

}  // namespace strata::openscad
