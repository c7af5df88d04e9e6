#pragma once
#include <cstdint>
#include <vector>

#include "strata/kernel/carriers.h"
#include "strata/kernel/exact_vertex.h"
#include "strata/kernel/point.h"
#include "strata/mesh/mesh.h"
#include "strata/mesh/monitor.h"

namespace strata {

/// Coordinates of input vertices, as they were given, and then of the named points, each rounded to the nearest double,
/// ties to even. O(1) per point.
[[nodiscard]] std::vector<Vertex> round_to_doubles(const Carriers& carriers, const std::vector<std::uint32_t>& inputs,
                                                   const std::vector<PointName>& points, const Monitor& monitor);

/// The same points, those whose exact place is not where `rounded` says, with that place.
[[nodiscard]] std::vector<ExactVertex> exact_places(const Carriers& carriers, const std::vector<std::uint32_t>& inputs,
                                                    const std::vector<PointName>& points,
                                                    const std::vector<Vertex>& rounded, const Monitor& monitor);

}  // namespace strata
