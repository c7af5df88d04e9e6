#include "extensions/contact/box_distance.h"

#include <array>
#include <cmath>

namespace strata::contact {

double half_distance(const Box& a, const Box& b) {
  constexpr double lost = 0x1p-1073;  // the error of halving subnormals
  std::array<double, 3> gap{};
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double below = a.lower[i] * 0.5 - b.upper[i] * 0.5, above = b.lower[i] * 0.5 - a.upper[i] * 0.5;
    gap[i] = std::max({below - lost, above - lost, 0.0});
    most = std::max(most, gap[i]);
  }
  if (!(most > 0)) return 0;
  double sum = 0;
  for (const double g : gap) sum += (g / most) * (g / most);
  return most * std::sqrt(sum) * (1 - 0x1p-48);
}

}  // namespace strata::contact
