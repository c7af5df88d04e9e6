#pragma once
#include <span>
#include <vector>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// A closed polygon; what it bounds is on the left of its sides.
using PolygonLoop = std::vector<RationalVector<2>>;

/// A directed side with the region on its left.
struct PlaneSide {
  RationalVector<2> from, to;
};

/// The region of the plane that sides bound. They must be the whole boundary of a region, without crossings and
/// overlaps; sides without length do not count.
[[nodiscard]] Partition<2> partition_of(std::span<const PlaneSide> sides);

/// The same for the sides of loops: outer ones counter-clockwise, holes clockwise.
[[nodiscard]] Partition<2> partition_of(std::span<const PolygonLoop> loops);

/// The boundary as directed sides; throws std::domain_error when it is not bounded.
[[nodiscard]] std::vector<PlaneSide> sides_of(const Partition<2>& region);

}  // namespace strata::bsp
