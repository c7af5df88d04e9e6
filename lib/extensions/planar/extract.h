#pragma once
#include "extensions/planar/subdivision.h"
#include "strata/planar.h"

namespace strata::planar {

/// The polygons of the faces with a label: components of these faces after edges between two of them are gone, each
/// with its loops. The arrangement's places are what the region's are taken from. O(edges), and a sort of the polygons.
[[nodiscard]] Region extract(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label);

}  // namespace strata::planar
