#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "strata/mesh.h"
#include "strata/planar.h"

namespace strata::openscad {

/// Collects vertices that may be rationals.
class VertexCollector {
 public:
  std::uint32_t add(const Vertex& p) {
    mesh_.mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh_.mesh.vertices.size() - 1);
  }
  std::uint32_t add(RationalPoint p) {
    Vertex nearest;
    bool is_exact = true;
    for (std::size_t i = 0; i < 3; ++i) {
      nearest[i] = to_nearest_double(p[i]);
      is_exact = is_exact && std::isfinite(nearest[i]) && to_rational(nearest[i]) == p[i];
    }
    const std::uint32_t number = add(nearest);
    if (!is_exact) mesh_.exact.push_back({number, std::move(p)});
    return number;
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(mesh_.mesh.vertices.size()); }
  /// Leaves out triangles with a vertex twice.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh_.mesh.triangles.push_back({a, b, c});
  }
  [[nodiscard]] const ExactMesh& mesh() const { return mesh_; }
  [[nodiscard]] ExactMesh take() { return std::move(mesh_); }

 private:
  ExactMesh mesh_;
};

/// The exact coordinates of a vertex of a region.
[[nodiscard]] inline planar::RationalPlacement position(const planar::Region& region, std::uint32_t vertex) {
  return planar::exact_position(region.loops.places, vertex);
}

}  // namespace strata::openscad
