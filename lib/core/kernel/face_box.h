#pragma once
#include <cmath>
#include <cstdint>

#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// Of a face of the first operand. A vertex that is not a double is at most half the distance to the next double away.
inline Box face_box(const InputComplex& input, std::uint32_t face) {
  const auto points = input.points(0);
  const auto& corners = input.faces(0)[face];
  Box box;
  for (const std::uint32_t v : corners) box.include(points[v]);
  if (input.has_doubles(corners)) return box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(box.lower[i], -Box::infinity);
    box.upper[i] = std::nextafter(box.upper[i], Box::infinity);
  }
  return box;
}

}  // namespace strata
