#include "core/mesh/circle.h"

#include <cmath>
#include <numbers>

namespace strata {
namespace {

constexpr double root_of_half = 0.70710678118654752440;            // sqrt(1/2)
constexpr double root_of_three_quarters = 0.86602540378443864676;  // sqrt(3/4)

/// For angles in [0, 90].
CosineSine in_first_quadrant(double degrees) {
  if (degrees == 30) return {root_of_three_quarters, 0.5};
  if (degrees == 45) return {root_of_half, root_of_half};
  if (degrees == 60) return {0.5, root_of_three_quarters};
  if (degrees > 45) {
    const double rest = (90 - degrees) * (std::numbers::pi / 180);
    return {std::sin(rest), std::cos(rest)};
  }
  const double angle = degrees * (std::numbers::pi / 180);
  return {std::cos(angle), std::sin(angle)};
}

/// Of 0 it is 0, not -0.
double opposite(double x) { return 0 - x; }

}  // namespace

CosineSine cosine_sine(double degrees) {
  const double quadrant = std::floor(degrees / 90);
  const CosineSine d = in_first_quadrant(degrees - 90 * quadrant);  // exact
  if (quadrant == 0) return d;
  if (quadrant == 1) return {opposite(d.sine), d.cosine};
  if (quadrant == 2) return {opposite(d.cosine), opposite(d.sine)};
  return {d.sine, opposite(d.cosine)};
}

}  // namespace strata
