#pragma once
#include "strata/mesh.h"
#include "support/random.h"

namespace strata::test {

/// The same solid in more triangles: edges divided in their middles, triangles at points inside, where chance has it.
/// Where a new vertex would have to be rounded there is none. O(steps * triangles).
[[nodiscard]] Mesh subdivided(Mesh mesh, Random& random, int steps);

}  // namespace strata::test
