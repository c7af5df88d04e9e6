#pragma once
#include <span>
#include <vector>

#include "extensions/scene/pieces.h"
#include "strata/query.h"

namespace strata {

[[nodiscard]] Rational value_at(const RationalPlane& plane, const RationalPoint& p);
[[nodiscard]] RationalPlane opposite(const RationalPlane& plane);

/// Appends the part of a convex polygon outside of a convex cone, as convex polygons: the polygon itself where the cone
/// does not meet its interior. The cone is where all planes are positive.
void cut_out(ExactPolygon polygon, std::span<const RationalPlane> cone, std::vector<ExactPolygon>& left);

}  // namespace strata
