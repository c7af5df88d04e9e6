#include "extensions/scene/direction_charts.h"

#include <cmath>

namespace strata {
namespace {

bool is_finite(const BoundedPoint& p) {
  return std::isfinite(p[0].value) && std::isfinite(p[1].value) && std::isfinite(p[2].value);
}

}  // namespace

DirectionCharts::DirectionCharts(const Origin& origin, const InputComplex::Coordinates& base)
    : origin_(origin), base_(origin.is_point() ? origin.at : base) {
  if (origin.is_point()) return;
  const auto& d = origin.at;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(d[i]) > std::abs(d[along_])) along_ = i;
  for (std::size_t i = 0; i < 2; ++i) slope_[i] = Bounded(d[(along_ + 1 + i) % 3]) / Bounded(d[along_]);
}

/// Only directions matter: where differences overflow, a quarter of both points is used.
BoundedPoint DirectionCharts::from_origin(const BoundedPoint& p) const {
  const BoundedPoint r{p[0] - base_[0], p[1] - base_[1], p[2] - base_[2]};
  if (is_finite(r) || !origin_.is_point()) return r;
  BoundedPoint quarter;
  for (std::size_t i = 0; i < 3; ++i) quarter[i] = p[i] * Bounded(.25) - Bounded(base_[i]) * Bounded(.25);
  return quarter;
}

ChartVector DirectionCharts::at(std::size_t chart, const BoundedPoint& p) const {
  const BoundedPoint r = from_origin(p);
  if (origin_.is_point()) {
    const std::size_t axis = chart / 2;
    const Bounded& w = r[axis];
    return {r[(axis + 1) % 3], r[(axis + 2) % 3], chart % 2 == 0 ? w : -w};
  }
  return {r[(along_ + 1) % 3] - slope_[0] * r[along_], r[(along_ + 2) % 3] - slope_[1] * r[along_], Bounded(1)};
}

Bounded DirectionCharts::depth(std::size_t chart, const BoundedPoint& p) const {
  const std::size_t axis = origin_.is_point() ? chart / 2 : along_;
  const Bounded r = p[axis] - base_[axis];
  const bool grows = origin_.is_point() ? chart % 2 == 0 : origin_.at[axis] > 0;
  return grows ? r : -r;
}

std::size_t DirectionCharts::chart_of(const BoundedPoint& p) const {
  if (!origin_.is_point()) return 0;
  const BoundedPoint r = from_origin(p);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(r[i].value) > std::abs(r[axis].value)) axis = i;
  return 2 * axis + (r[axis].value < 0 ? 1 : 0);
}

}  // namespace strata
