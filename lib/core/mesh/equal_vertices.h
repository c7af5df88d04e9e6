#pragma once
#include <cstdint>
#include <optional>
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

/// The triangles of a mesh, each on the first of its equal vertices. Sheets that touch in a vertex then share it.
[[nodiscard]] std::vector<Triangle> on_first_vertices(ExactMeshView mesh, const Monitor& monitor = {});

/// The same, to be looked at: where no vertices are equal, these are the triangles of the mesh, which must stay.
class OnFirstVertices {
 public:
  explicit OnFirstVertices(ExactMeshView mesh, const Monitor& monitor = {});
  explicit OnFirstVertices(const NearestMesh& mesh);  ///< compares where nearest doubles are equal
  OnFirstVertices(const OnFirstVertices&) = delete;
  OnFirstVertices& operator=(const OnFirstVertices&) = delete;

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] bool are_given() const { return changed_.empty(); }  ///< no triangle has another vertex than before

 private:
  OnFirstVertices(std::span<const Triangle> triangles, const std::optional<std::vector<std::uint32_t>>& first);

  std::vector<Triangle> changed_;
  std::span<const Triangle> triangles_;
};

}  // namespace strata
