#pragma once
#include <cstdint>

#include "strata/exact/rational.h"
#include "strata/mesh/exact_mesh.h"

namespace strata {

/// Facts about a closed mesh that survive re-triangulation.
/// Vertices with equal coordinates are one vertex; triangles that repeat a vertex are left out.
struct Topology {
  std::uint64_t components = 0;            ///< connected over shared vertices (equal coordinates are one vertex)
  std::int64_t euler = 0;                  ///< V - E + F over used vertices, undirected edges and triangles
  std::uint64_t non_manifold_edges = 0;    ///< edges with more than two triangles
  std::uint64_t non_manifold_vertices = 0; ///< vertices whose triangles do not form one fan over manifold edges
  std::uint64_t open_edges = 0;            ///< edges whose directed occurrences do not cancel
};

/// Signed volume: sum of det(a, b, c) / 6 over the triangles. Exact; positive when normals point outwards.
/// O(n) on fixed-width integers where coordinates allow it.
[[nodiscard]] Rational volume(ExactMeshView mesh);

/// Surface area, correct to a few units in the last place of a double.
[[nodiscard]] double area(const ExactMesh& mesh);

/// Indices must be in range. O(n log d) for vertices of degree d.
[[nodiscard]] Topology topology(const ExactMesh& mesh);

}  // namespace strata
