#include "strata/srgb.h"

#include <algorithm>
#include <cmath>

namespace strata {

double light_of_srgb(double component) {
  const double x = std::clamp(component, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

double srgb_of_light(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

}  // namespace strata
