#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/carry_attributes.h"
#include "strata/surface.h"

namespace strata {

/// Some triangles of a mesh, with the vertices that they use, in the order in which they come.
class MeshPart {
 public:
  /// `number` has an entry per vertex of the mesh, all of them the greatest number; it is left like that.
  MeshPart(const ExactMesh& mesh, std::vector<std::uint32_t>& number) : mesh_(mesh), number_(number) {}
  MeshPart(const MeshPart&) = delete;
  MeshPart& operator=(const MeshPart&) = delete;
  ~MeshPart();

  void add(const Triangle& triangle, bool is_reversed);
  [[nodiscard]] ExactMesh mesh() &&;

 private:
  const ExactMesh& mesh_;
  std::vector<std::uint32_t>& number_;
  std::vector<std::uint32_t> used_;
  ExactMesh part_;
};

/// True when none of these has attributes.
[[nodiscard]] bool carry_nothing(std::span<const Surface> surfaces);
/// Surfaces as what `carry_attributes` takes from.
[[nodiscard]] std::vector<AttributedMesh> attributed_meshes(std::span<const Surface> surfaces);

/// Cells of an arrangement as solids.
[[nodiscard]] std::vector<Solid> solids_of(const Arrangement& a, std::span<const std::uint32_t> cells);

}  // namespace strata
