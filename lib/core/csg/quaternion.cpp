#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/mesh/circle.h"
#include "strata/transform.h"

namespace strata {

Quaternion Quaternion::of_tangent(const RationalPoint& axis, const Rational& tangent) {
  return {1, tangent * axis[0], tangent * axis[1], tangent * axis[2]};
}

Quaternion Quaternion::of_angle(const std::array<double, 3>& axis, double degrees) {
  const double largest = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
  if (!std::isfinite(axis[0]) || !std::isfinite(axis[1]) || !std::isfinite(axis[2]) || !std::isfinite(degrees))
    throw std::invalid_argument("an axis or an angle is not finite");
  if (largest == 0) throw std::invalid_argument("the axis of a rotation is zero");
  std::array<double, 3> unit{};
  for (std::size_t i = 0; i < 3; ++i) unit[i] = axis[i] / largest;  // squares neither vanish nor grow beyond doubles
  const double length = std::sqrt(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2]);
  const double within = std::fmod(degrees, 360);  // exact; both signs of a quaternion are the same rotation
  const CosineSine half = cosine_sine(std::abs(within) / 2);
  const double sine = within < 0 ? -half.sine : half.sine;
  return {half.cosine, sine * unit[0] / length, sine * unit[1] / length, sine * unit[2] / length};
}

}  // namespace strata
