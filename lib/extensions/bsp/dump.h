#pragma once
#include <string_view>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// Reads a tree as Hipparchus and Commons Math dump it ("PolyhedronsSet", a tolerance, then nodes from the root, each
/// "internal" with a point and the normal of its plane, minus child first, or "leaf true|false"). Numbers are doubles,
/// taken as they are written; the tolerances are not used. Throws std::runtime_error with the line of what cannot be
/// read.
[[nodiscard]] Partition<3> read_polyhedrons_set(std::string_view text);

}  // namespace strata::bsp
