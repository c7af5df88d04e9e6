#include "core/io/srgb.h"

#include <algorithm>
#include <cmath>

#include "strata/srgb.h"

namespace strata::io {

double linear_of_srgb(std::uint8_t byte) { return light_of_srgb(byte / 255.0); }

std::uint8_t srgb_of_linear(double linear) { return byte_of(srgb_of_light(linear)); }

std::uint8_t byte_of(double value) {
  const double x = std::clamp(value, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255 * (std::isnan(x) ? 0 : x)));
}

}  // namespace strata::io
