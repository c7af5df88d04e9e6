#pragma once
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// True when faces that follow one another are mostly far apart in the lists of a large mesh, so that every pass over
/// it waits for memory: the order in which subdivision that appends, or a shuffled file, leaves them. Judged by a
/// sample. Any mesh. O(1).
[[nodiscard]] bool is_scattered(MeshView mesh);

/// The same triangles in an order in which neighbours in space are neighbours in the lists: vertices along a Z-curve,
/// faces by their first vertex there, corners as they were. For what does not depend on numbers; passes over it are
/// several times as fast as over a scattered mesh. Requires finite coordinates and valid indices. O(n). Throws
/// Cancelled.
[[nodiscard]] Mesh gathered(MeshView mesh, const Monitor& monitor);

}  // namespace strata
