#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/exact/rational.h"
#include "strata/kernel/exact_vertex.h"
#include "strata/mesh/mesh.h"

namespace strata {

/// A triangle mesh whose vertices are rationals. `mesh` holds every coordinate rounded to the nearest double;
/// `exact` lists the vertices for which that changed something, in increasing order of index.
struct ExactMesh {
  Mesh mesh;
  std::vector<ExactVertex> exact;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size()).
};

/// An exact mesh that someone else owns; valid as long as the arrays it looks at.
struct ExactMeshView {
  MeshView mesh;
  std::span<const ExactVertex> exact;

  ExactMeshView() = default;
  ExactMeshView(MeshView m, std::span<const ExactVertex> e) : mesh(m), exact(e) {}
  ExactMeshView(const ExactMesh& m) : mesh(m.mesh), exact(m.exact) {}  // NOLINT: a view of a mesh is implicit

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size()).
};

}  // namespace strata
