#pragma once
#include <span>
#include <vector>

#include "core/overlap/self_intersections.h"
#include "core/round/grid_rounding.h"
#include "strata/mesh.h"

namespace strata {

/// Joins near vertices of faces that cross: those at a distance of at most `reach` units of the grid, in the maximum
/// norm, whether an edge connects them or not. In the order of their numbers, each vertex that is not joined to another
/// stays, and takes those near it. The surface stays closed; faces that lost a side repeat a vertex.
///
/// Returns per triangle how far a corner moved at most, 0 for most. O(n + k log k) for k pairs of near vertices.
[[nodiscard]] std::vector<double> join_near_vertices(Mesh& mesh, std::span<const SelfIntersection> pairs,
                                                     const GridRounding& grid, double reach);

}  // namespace strata
