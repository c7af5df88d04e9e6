#pragma once
#include <cstdint>
#include <vector>

#include "core/mesh/planar_levels.h"

namespace strata::facets {

using Loop = std::vector<std::uint32_t>;

/// The boundary of a region as closed polygons, with the region on the left seen from outside. Where several polygons
/// meet at a vertex, each follows one sector of the region. So parts of the region that touch at a vertex only have
/// separate boundaries. Vertices at which one polygon goes straight on and no other passes are removed. O(n log n).
[[nodiscard]] std::vector<Loop> boundary_loops(const PointTable& points, Projection axes, const Region& region);

}  // namespace strata::facets
