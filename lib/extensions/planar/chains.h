#pragma once
#include "extensions/planar/subdivision.h"

namespace strata::planar {

/// Steps of `subdivide`. Each computes its part of the subdivision from the previous parts.

/// Rings cut into chains. Returns every ring's least vertex (none for rings without pieces).
std::vector<std::uint32_t> cut_into_chains(const Arrangement& a, std::span<const std::uint32_t> first_segment,
                                           ChainEnds ends, Subdivision& s);

/// Half-edges sorted around nodes, coinciding chains made one edge, `next`.
void sort_around_nodes(const Arrangement& a, Subdivision& s);

/// Components by their least vertices, and the faces that contain them.
void find_components(const Arrangement& a, std::span<const std::uint32_t> least_of_ring, std::size_t patience,
                     Subdivision& s);

}  // namespace strata::planar
