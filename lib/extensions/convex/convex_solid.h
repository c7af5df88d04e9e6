#pragma once
#include <optional>

#include "extensions/convex/surface.h"
#include "strata/convex.h"

namespace strata::convex {

/// A solid as a polytope, if it is convex: one component without cavities whose edges are convex or flat. Exact. O(n
/// log n). A closed connected surface that is convex at all of its edges and fans bounds a convex solid. Throws
/// Cancelled.
[[nodiscard]] std::optional<Polytope> convex_solid(const Surface& surface, const Monitor& monitor = {});

}  // namespace strata::convex
