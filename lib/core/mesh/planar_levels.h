#pragma once
#include <vector>

#include "core/mesh/planar_chain.h"

namespace strata::facets {

/// Which of the two sides of a plane is outside. `front` facets are counter-clockwise as projected.
enum class Facing { front, back };

/// The boundary of the region that is covered at least `level` times more often by facets of this facing than by
/// those of the other one. Sides have the region on their left seen from outside. Level 1 is all there is for the
/// boundary of a solid.
struct Region {
  Facing facing;
  std::int64_t level;
  std::vector<Side> sides;
};

/// The regions bounded by a chain whose edges meet at end points only.
/// A sweep in lexicographic order carries how often the plane is covered below each edge; O(n log n) exact turns.
[[nodiscard]] std::vector<Region> covered_regions(const PointTable& points, Projection axes, const Chain& chain);

}  // namespace strata::facets
