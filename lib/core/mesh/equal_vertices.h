#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"

namespace strata {

/// For every vertex the smallest index of a vertex with equal coordinates (-0 = 0). Coordinates that are not finite
/// are compared bit by bit. Expected O(n).
[[nodiscard]] std::vector<std::uint32_t> equal_vertices(std::span<const Vertex> vertices);

/// The same for exact coordinates.
[[nodiscard]] std::vector<std::uint32_t> equal_vertices(ExactMeshView mesh);

/// The triangles of a mesh, each on the first of its equal vertices. Sheets that touch in a vertex then share it.
[[nodiscard]] std::vector<Triangle> on_first_vertices(ExactMeshView mesh);

}  // namespace strata
