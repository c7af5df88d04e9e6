#pragma once
#include "strata/planar/region.h"
#include "strata/planar/subdivision.h"

namespace strata::plane {

/// The polygons of the faces with a label: components of these faces after edges between two of them are gone, each
/// with its loops. The arrangement's places are what the region's are taken from. O(edges), and a sort of the polygons.
[[nodiscard]] Region extract(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label);

}  // namespace strata::plane
