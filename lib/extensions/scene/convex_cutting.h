#pragma once
#include <span>
#include <vector>

#include "extensions/scene/pieces.h"

namespace strata {

/// A convex polygon in space, counter-clockwise like the face that it is in.
using ExactPolygon = std::vector<RationalPoint>;

[[nodiscard]] Rational value_at(const RationalPlane& plane, const RationalPoint& p);
[[nodiscard]] RationalPlane opposite(const RationalPlane& plane);

/// Appends what is left of a convex polygon outside of a convex cone, as convex polygons: the polygon itself where the
/// cone does not reach inside it. The cone is where all planes are positive.
void cut_out(ExactPolygon polygon, std::span<const RationalPlane> cone, std::vector<ExactPolygon>& left);

}  // namespace strata
