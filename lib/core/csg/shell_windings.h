#pragma once
#include <cstdint>
#include <vector>

#include "core/overlap/shells.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Per shell of a closed mesh without self-intersections: the winding number just above it, on the outer side of its
/// faces. A solid has 0 everywhere. O(n) for one shell; else as much as a union of the shells whose boxes overlap.
[[nodiscard]] std::vector<std::int32_t> windings_above(ExactMeshView mesh, const Shells& shells,
                                                       const Monitor& monitor);

}  // namespace strata
