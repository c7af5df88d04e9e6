#pragma once
#include "extensions/convex/loops.h"
#include "extensions/convex/quickhull.h"

namespace strata::convex {

/// The maximal facets of a hull: its triangles grouped by plane, without the points inside facets or edges.
/// O(triangles).
[[nodiscard]] Loops maximal_facets(const Quickhull& hull, std::uint32_t points);

}  // namespace strata::convex
