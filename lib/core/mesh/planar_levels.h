#pragma once
#include <vector>

#include "core/mesh/planar_chain.h"

namespace strata::facets {

/// The orientation of facets of one plane. `front` facets are counter-clockwise in the projection.
enum class Facing { front, back };

/// The boundary of the region that is covered at least `level` times more often by facets of this orientation than by
/// those of the other one. Sides have the region on their left seen from outside. The boundary of a solid has level 1
/// only.
struct Region {
  Facing facing;
  std::int64_t level;
  std::vector<Side> sides;
};

/// The regions bounded by a chain whose edges meet at end points only. A sweep in lexicographic order propagates the
/// coverage below each edge; O(n log n) exact orientation tests.
[[nodiscard]] std::vector<Region> covered_regions(const PointTable& points, Projection axes, const Chain& chain);

}  // namespace strata::facets
