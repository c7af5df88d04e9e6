#pragma once
#include <optional>
#include <vector>

#include "extensions/contact/line_intervals.h"
#include "strata/rational.h"

namespace strata::contact {

/// A closed convex polygon in space, in rationals. O(corners) for each query.
class ConvexPolygon {
 public:
  /// Requires corners in order around it, of which the first three are not on one line.
  explicit ConvexPolygon(std::vector<RationalPoint> corners);

  [[nodiscard]] bool has(const RationalPoint& p) const;
  /// The parameters t of a line p + t d with points in the polygon, if there is more than one and the line lies in the
  /// polygon's plane.
  [[nodiscard]] std::optional<Interval> part_of_line(const RationalPoint& p, const RationalPoint& d) const;

 private:
  std::vector<RationalPoint> corners_;
  std::vector<RationalPoint> inward_;  ///< per side, perpendicular to it in the polygon's plane
  RationalPoint normal_;
};

}  // namespace strata::contact
