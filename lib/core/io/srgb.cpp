#include "core/io/srgb.h"

#include <algorithm>
#include <cmath>

namespace strata::io {

double linear_of_srgb(std::uint8_t byte) {
  const double x = byte / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb_of_linear(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return byte_of(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

std::uint8_t byte_of(double value) {
  const double x = std::clamp(value, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255 * (std::isnan(x) ? 0 : x)));
}

}  // namespace strata::io
