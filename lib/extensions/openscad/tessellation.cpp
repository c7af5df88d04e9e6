#include "extensions/openscad/tessellation.h"

#include <algorithm>
#include <cmath>

namespace strata::openscad {

std::uint32_t sides_of_circle(double radius, const Resolution& resolution) {
  constexpr double finest = 1.0 / (1 << 20), most = 1U << 31, least = 0.01;
  if (radius < finest || !std::isfinite(resolution.fn)) return 3;
  double sides = std::ceil(std::max(resolution.fn, 3.0));
  if (resolution.fn <= 0) {
    const double by_angle = 360 / std::max(resolution.fa, least);
    const double by_length = radius * 2 * 3.14159265358979323846 / std::max(resolution.fs, least);
    sides = std::ceil(std::max(std::min(by_angle, by_length), 5.0));
  }
  return static_cast<std::uint32_t>(std::min(sides, most));
}

}  // namespace strata::openscad
