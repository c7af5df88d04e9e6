#pragma once
#include <boost/container/static_vector.hpp>

#include "core/kernel/point.h"
#include "core/overlap/constraint.h"

namespace strata::contact {

/// Names of the corners of the intersection of two faces: a point, the ends of a segment, or the corners of a convex
/// polygon in no order. Different names are different positions.
using CommonPoints = boost::container::static_vector<SymbolicPoint, 32>;

/// The intersection of two faces, from the constraints that `meet_faces` finds for them alone. Where two vertices meet,
/// the name is that of the first face.
[[nodiscard]] CommonPoints common_points(const InputComplex& input, const PairIntersections& intersections);

/// True when these faces lie in one plane.
[[nodiscard]] inline bool are_coplanar(const PairIntersections& intersections) {
  return !intersections.constraints.empty() && intersections.constraints.front().kind == ConstraintKind::coplanar;
}

/// True when the intersection of two faces has an area.
[[nodiscard]] inline bool share_area(const InputComplex& input, const PairIntersections& intersections) {
  return are_coplanar(intersections) && common_points(input, intersections).size() >= 3;
}

}  // namespace strata::contact
