#include "core/cells/grid.h"

#include <cmath>

namespace strata {

Grid::Grid(const InputComplex::Coordinates& lower, const InputComplex::Coordinates& upper) {
  double longest = 0;  // halved, so that it cannot overflow
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, upper[i] * 0.5 - lower[i] * 0.5);
  int exponent = 0;
  std::frexp(longest, &exponent);  // longest < 2^exponent
  const int shift = longest > 0 ? 29 - exponent : 0;
  // 2^shift may exceed the range of doubles: two factors.
  scale1_ = std::ldexp(1.0, shift / 2);
  scale2_ = std::ldexp(1.0, shift - shift / 2);
  for (std::size_t i = 0; i < 3; ++i) offset_[i] = lower[i] * scale1_ * scale2_;
}

double Grid::inverse(int axis, std::int32_t g) const {
  return (g + offset_[static_cast<std::size_t>(axis)]) / scale1_ / scale2_;
}

}  // namespace strata
