#pragma once
#include <cstdint>

#include "extensions/complex/soup.h"

namespace strata::complex {

/// Appends a triangle that is no part of a face and has an edge from vertex a to vertex b as its first side.
void add_triangle_at_edge(Soup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t edge_cell);

/// Appends one with a corner at a vertex.
void add_triangle_at_vertex(Soup& soup, std::uint32_t v);

}  // namespace strata::complex
