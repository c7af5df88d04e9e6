#pragma once
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/point_table.h"
#include "core/select/boundary.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// Coordinates of a boundary's vertices: input vertices as they were given, and constructed points each rounded to the
/// nearest double, ties to even. O(1) per point.
[[nodiscard]] std::vector<Vertex> round_to_doubles(const InputComplex& input, const PointTable& points,
                                                   const Boundary& boundary, const Monitor& monitor);

/// The same points, those whose exact place is not where `rounded` says, with that place.
[[nodiscard]] std::vector<ExactVertex> exact_positions(const InputComplex& input, const PointTable& points,
                                                       const Boundary& boundary, const std::vector<Vertex>& rounded,
                                                       const Monitor& monitor);

}  // namespace strata
