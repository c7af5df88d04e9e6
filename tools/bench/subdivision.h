#pragma once
#include "strata/mesh.h"

namespace bench {

/// Every triangle split into four at the middles of its sides.
[[nodiscard]] strata::Mesh halved(const strata::Mesh& mesh);

/// The same split, with vertices moved towards a smooth surface. Closed manifold meshes only.
/// Source: Loop 1987, with Warren's weights.
[[nodiscard]] strata::Mesh loop_subdivided(const strata::Mesh& mesh);

}  // namespace bench
