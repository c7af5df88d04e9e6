#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/nearest_mesh.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// For every vertex the smallest index of a vertex with equal coordinates (-0 = 0). Coordinates that are not finite
/// are compared bit by bit. Expected O(n).
[[nodiscard]] std::vector<std::uint32_t> equal_vertices(std::span<const Vertex> vertices, const Monitor& monitor = {});

/// The same for exact coordinates.
[[nodiscard]] std::vector<std::uint32_t> equal_vertices(ExactMeshView mesh, const Monitor& monitor = {});

/// The same; positions are asked for only where the nearest doubles of two vertices are equal.
[[nodiscard]] std::vector<std::uint32_t> equal_vertices(const NearestMesh& mesh);

/// The triangles of a mesh, each on the first of its equal vertices. Sheets that touch in a vertex then share it.
[[nodiscard]] std::vector<Triangle> on_first_vertices(ExactMeshView mesh, const Monitor& monitor = {});
[[nodiscard]] std::vector<Triangle> on_first_vertices(const NearestMesh& mesh);

}  // namespace strata
