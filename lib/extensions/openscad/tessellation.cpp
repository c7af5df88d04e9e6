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

Resolution resolution_of(const Arguments& arguments) {
  const Resolution usual;
  const Resolution r{arguments.number("$fn", usual.fn), arguments.number("$fa", usual.fa),
                     arguments.number("$fs", usual.fs)};
  if (std::isnan(r.fa)) arguments.fail("$fa", "is no number");
  if (std::isnan(r.fs)) arguments.fail("$fs", "is no number");
  if (arguments.number("$fe", 0) != 0) arguments.fail("$fe", "is not supported");
  return r;
}

double radius_of(const Arguments& arguments, std::string_view diameter, std::string_view radius, double otherwise) {
  if (arguments.find(diameter) != nullptr) return arguments.number(diameter, 0) / 2;
  return arguments.number(radius, otherwise);
}

}  // namespace strata::openscad
