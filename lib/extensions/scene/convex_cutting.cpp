#include "extensions/scene/convex_cutting.h"

#include <algorithm>
#include <utility>

namespace strata {
namespace {

/// The parts of a convex polygon on both sides of a plane; a side without interior points is empty.
struct Halves {
  ExactPolygon above, below;
};

Halves halve(const ExactPolygon& polygon, const RationalPlane& plane) {
  std::vector<Rational> value;
  for (const RationalPoint& p : polygon) value.push_back(value_at(plane, p));
  const bool any_above = std::any_of(value.begin(), value.end(), [](const Rational& v) { return v > 0; });
  const bool any_below = std::any_of(value.begin(), value.end(), [](const Rational& v) { return v < 0; });
  if (!any_below) return {polygon, {}};
  if (!any_above) return {{}, polygon};
  Halves halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (value[i] >= 0) halves.above.push_back(polygon[i]);
    if (value[i] <= 0) halves.below.push_back(polygon[i]);
    if ((value[i] > 0 && value[j] < 0) || (value[i] < 0 && value[j] > 0)) {
      const Rational t = value[i] / (value[i] - value[j]);
      RationalPoint x;
      for (std::size_t k = 0; k < 3; ++k) x[k] = polygon[i][k] + t * (polygon[j][k] - polygon[i][k]);
      halves.above.push_back(x);
      halves.below.push_back(std::move(x));
    }
  }
  return halves;
}

}  // namespace

Rational value_at(const RationalPlane& plane, const RationalPoint& p) {
  return plane.normal[0] * p[0] + plane.normal[1] * p[1] + plane.normal[2] * p[2] - plane.offset;
}

RationalPlane opposite(const RationalPlane& plane) {
  return {{-plane.normal[0], -plane.normal[1], -plane.normal[2]}, -plane.offset};
}

void cut_out(ExactPolygon polygon, std::span<const RationalPlane> cone, std::vector<ExactPolygon>& left) {
  std::vector<ExactPolygon> outside;
  ExactPolygon inside = polygon;
  for (const RationalPlane& plane : cone) {
    Halves halves = halve(inside, plane);
    if (halves.above.empty()) {
      left.push_back(std::move(polygon));
      return;
    }
    if (!halves.below.empty()) outside.push_back(std::move(halves.below));
    inside = std::move(halves.above);
  }
  std::move(outside.begin(), outside.end(), std::back_inserter(left));
}

}  // namespace strata
