#pragma once
#include <boost/container/static_vector.hpp>

#include "strata/kernel/point.h"
#include "strata/overlap/constraint.h"

namespace strata::contact {

/// Names of the corners of what two faces share: a point, the ends of a segment, or the corners of a convex polygon in
/// no order. Corners where two vertices meet may occur under both names.
using CommonPoints = boost::container::static_vector<PointName, 32>;

/// What two faces, and no others, have in common, from what `meet_faces` says about them. Each name once.
[[nodiscard]] CommonPoints common_points(const Carriers& carriers, const Meetings& meetings);

/// True when these faces lie in one plane.
[[nodiscard]] inline bool are_coplanar(const Meetings& meetings) {
  return !meetings.constraints.empty() && meetings.constraints.front().kind == ConstraintKind::coplanar;
}

/// True when two faces, and what they share, prove by themselves that the interiors of their solids meet: they cross in
/// the insides of both, or lie on one another looking the same way. theory.md, section 2.
[[nodiscard]] bool proves_interference(const Carriers& carriers, const Meetings& meetings);

}  // namespace strata::contact
