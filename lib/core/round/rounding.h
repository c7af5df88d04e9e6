#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/select/extract.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// Coordinates of a boundary's vertices: input vertices unchanged, constructed points rounded to the nearest double,
/// ties to even. O(1) per point.
[[nodiscard]] std::vector<Vertex> round_to_doubles(const InputComplex& input, const Boundary& boundary,
                                                   const Monitor& monitor);

/// Those vertices whose exact positions differ from `rounded`. O(1) per constructed point, mostly in doubles.
[[nodiscard]] std::vector<std::uint32_t> rounded_vertices(const InputComplex& input, const Boundary& boundary,
                                                          const std::vector<Vertex>& rounded, const Monitor& monitor);

/// Whether two vertices of the boundary have one position. Exact; mostly in sums of two doubles.
[[nodiscard]] bool are_equal(const InputComplex& input, const Boundary& boundary, std::uint32_t a, std::uint32_t b);

/// The exact positions of those vertices that differ from `rounded`.
[[nodiscard]] std::vector<ExactVertex> exact_positions(const InputComplex& input, const Boundary& boundary,
                                                       std::span<const Vertex> rounded, const Monitor& monitor);

}  // namespace strata
