#pragma once
#include <vector>

#include "strata/kernel/carriers.h"
#include "strata/kernel/exact_vertex.h"
#include "strata/mesh/mesh.h"
#include "strata/mesh/monitor.h"
#include "strata/overlap/point_table.h"
#include "strata/select/boundary.h"

namespace strata {

/// Coordinates of a boundary's vertices: input vertices as they were given, and constructed points each rounded to the
/// nearest double, ties to even. O(1) per point.
[[nodiscard]] std::vector<Vertex> round_to_doubles(const Carriers& carriers, const PointTable& points,
                                                   const Boundary& boundary, const Monitor& monitor);

/// The same points, those whose exact place is not where `rounded` says, with that place.
[[nodiscard]] std::vector<ExactVertex> exact_places(const Carriers& carriers, const PointTable& points,
                                                    const Boundary& boundary, const std::vector<Vertex>& rounded,
                                                    const Monitor& monitor);

}  // namespace strata
