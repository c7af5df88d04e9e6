#pragma once
#include "extensions/planar/subdivision.h"
#include "strata/planar.h"

namespace strata::planar {

/// The polygons of the faces with a label: components of these faces after edges between two of them are removed, each
/// with its loops. Positions are copied from the arrangement. O(edges), and a sort of the polygons.
[[nodiscard]] Region extract(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label);

}  // namespace strata::planar
