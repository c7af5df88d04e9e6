#pragma once
#include <span>
#include <vector>

#include "core/overlap/self_intersections.h"
#include "core/round/grid_rounding.h"
#include "strata/mesh.h"

namespace strata {

/// Contracts short sides of faces that cross: those of at most `reach` units of the grid, in the maximum norm. A vertex
/// goes to one of its neighbours, which stays where it is. The surface stays closed; faces that lost a side repeat a
/// vertex.
///
/// Returns per triangle how far a corner moved at most, 0 for most. O(n + pairs log pairs).
[[nodiscard]] std::vector<double> contract_short_sides(Mesh& mesh, std::span<const SelfIntersection> pairs,
                                                       const GridRounding& grid, double reach);

}  // namespace strata
