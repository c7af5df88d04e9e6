#include "core/cells/raster.h"

#include <limits>

namespace strata {

BrickBounds::BrickBounds(const BrickGrid& bricks) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& bounds = bounds_[static_cast<std::size_t>(axis)];
    bounds.push_back(-infinity);
    for (std::uint32_t k = 1; k < bricks.size(axis); ++k) bounds.push_back(bricks.lower_bound(axis, k));
    bounds.push_back(infinity);
  }
}

PlaneFilter::PlaneFilter(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                         const InputComplex::Coordinates& c)
    : a_(a) {
  InputComplex::Coordinates u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    n_[i] = u[j] * v[k] - u[k] * v[j];
    scale_[i] = std::abs(u[j] * v[k]) + std::abs(u[k] * v[j]);
  }
}

Raster::Raster(const InputComplex& input, const BrickGrid& bricks)
    : bricks_(bricks), bounds_(bricks), is_exact_(!input.has_rationals()) {}

}  // namespace strata
