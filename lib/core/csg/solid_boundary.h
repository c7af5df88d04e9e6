#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "core/mesh/across_solid.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "strata/mesh.h"

namespace strata {

/// The boundary of a solid, with one number for equal vertices. Refers to the mesh.
class SolidBoundary {
 public:
  explicit SolidBoundary(ExactMeshView mesh)
      : mesh_(mesh), triangles_(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end()) {
    const std::vector<std::uint32_t> first = equal_vertices(mesh);
    for (Triangle& t : triangles_)
      for (std::uint32_t& v : t) v = first[v];
    input_.add(mesh_.mesh.vertices, triangles_, mesh_.exact);
  }
  SolidBoundary(const SolidBoundary&) = delete;
  SolidBoundary& operator=(const SolidBoundary&) = delete;

  [[nodiscard]] const ExactMeshView& mesh() const { return mesh_; }
  [[nodiscard]] const InputComplex& input() const { return input_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

  /// Calls visit(use, other, is_only) for every wedge of the interior at every edge: the two uses of the edge by the
  /// faces that bound the wedge, and whether there is no other wedge. O(n log d) for vertices of degree d, and for
  /// edges of many faces the square of their number.
  template <class Visit>
  void for_each_wedge(const Visit& visit) const {
    const AcrossSolid across_solid([&](const EdgeUse& use, const EdgeUse& other) {
      const Triangle &t = triangles_[use.triangle], &o = triangles_[other.triangle];
      return orient3d(input_, t[0], t[1], t[2], o[(other.corner + 2U) % 3]);
    });
    const std::vector<EdgeUse> uses = edge_table(triangles_, mesh_.mesh.vertices.size());
    for_each_edge(uses, [&](std::span<const EdgeUse> around) {
      if (around.size() == 2) return visit(around[0], around[1], true);
      for (const EdgeUse& use : around)
        if (use.forward) visit(use, across_solid(use, around), false);
    });
  }

 private:
  ExactMeshView mesh_;
  std::vector<Triangle> triangles_;
  InputComplex input_;
};

}  // namespace strata
