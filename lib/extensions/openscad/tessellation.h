#pragma once
#include <cstdint>

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

}  // namespace strata::openscad
