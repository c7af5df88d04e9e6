#pragma once
#include <array>
#include <cstddef>

#include "core/kernel/filters.h"
#include "core/kernel/input_complex.h"
#include "strata/query.h"

namespace strata {

/// A direction from the origin in a chart: (u, v, w), any positive multiple of it; in the chart's plane (u/w, v/w).
using ChartVector = std::array<Bounded, 3>;

/// Maps of the directions from an origin to planes. Straight lines remain straight: the tetrahedron of a face and the
/// origin is seen as a triangle wherever w > 0.
///
/// Six charts surround a point, one per side of a cube about it: w is the coordinate across the side, and the chart's
/// domain is |u|, |v| <= w. Directions at the rims are in several charts. An origin at infinity has one chart, whose
/// domain is the plane; there (u, v) are coordinates along the rays' direction, and w = 1.
class DirectionCharts {
 public:
  /// Coordinates at an infinite origin are differences from `base`, so that their errors are relative to the scene's
  /// size.
  DirectionCharts(const Origin& origin, const InputComplex::Coordinates& base);

  [[nodiscard]] std::size_t count() const { return origin_.is_point() ? 6 : 1; }
  [[nodiscard]] bool is_bounded() const { return origin_.is_point(); }

  /// Within bounds; overflow makes them infinite or NaN.
  [[nodiscard]] ChartVector at(std::size_t chart, const BoundedPoint& p) const;

  /// Increases along rays: no point of the segment from the origin to p has more than p's. In the chart of p's
  /// direction, or any that contains it.
  [[nodiscard]] Bounded depth(std::size_t chart, const BoundedPoint& p) const;

  /// A chart with p's direction in its domain. Any, if p is the origin.
  [[nodiscard]] std::size_t chart_of(const BoundedPoint& p) const;

 private:
  [[nodiscard]] BoundedPoint from_origin(const BoundedPoint& p) const;

  Origin origin_;
  InputComplex::Coordinates base_;
  std::size_t along_ = 0;           ///< the axis in which the direction is longest
  std::array<Bounded, 2> slope_{};  ///< of the direction in the two other axes, relative to that one
};

}  // namespace strata
