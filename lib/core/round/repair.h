#pragma once
#include "core/kernel/grid_rounding.h"
#include "core/round/flip_caps.h"
#include "core/round/moving_mesh.h"
#include "core/round/wrong_faces.h"

namespace strata {

/// Changes faces that are wrong such that as a rule they no longer are: without new vertices, and moving nothing by
/// more than `reach` units of the grid at once. In this order:
///
/// - vertices with equal coordinates become one;
/// - vertices of wrong faces at a distance of at most `reach` units, in the maximum norm, are joined, whether an edge
///   connects them or not. In the order of their numbers, each vertex that is not joined to another stays, and takes
///   those near it;
/// - of two triangles with the same vertices, one the reverse of the other, nothing is left;
/// - wrong faces whose height over their longest side is at most `reach` units are flipped with a neighbour across it
///   (`flip_caps.h`).
///
/// The chain stays closed. Returns whether anything changed. The same for any number of threads. O(n + k log k) for k
/// pairs of near vertices.
[[nodiscard]] bool repair(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
                          const GridRounding& grid, double reach, Bundles bundles);

}  // namespace strata
