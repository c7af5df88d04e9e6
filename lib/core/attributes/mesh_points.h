#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/exact/double_double.h"
#include "core/kernel/nearest.h"
#include "core/kernel/rational_point.h"
#include "strata/mesh.h"

namespace strata {

/// The vertices of a mesh as exact points. Refers to the mesh.
class MeshPoints {
 public:
  /// Throws std::invalid_argument where exact vertices are not in order, or are none of the mesh.
  explicit MeshPoints(ExactMeshView mesh) : mesh_(mesh) {
    if (mesh.exact.empty()) return;
    const auto is_out_of_order = [](const ExactVertex& a, const ExactVertex& b) { return a.vertex >= b.vertex; };
    if (std::adjacent_find(mesh.exact.begin(), mesh.exact.end(), is_out_of_order) != mesh.exact.end() ||
        mesh.exact.back().vertex >= mesh.mesh.vertices.size())
      throw std::invalid_argument("exact vertices are not in order, or of no vertex");
    first_listed_ = mesh.exact.front().vertex;
    listed_.assign(mesh.mesh.vertices.size() - first_listed_, nullptr);
    for (const ExactVertex& e : mesh.exact) listed_[e.vertex - first_listed_] = &e.position;
  }

  [[nodiscard]] const MeshView& mesh() const { return mesh_.mesh; }
  [[nodiscard]] const Vertex& nearest(std::uint32_t v) const { return mesh_.mesh.vertices[v]; }
  /// The position, where it is not three doubles.
  [[nodiscard]] const RationalPoint* rational(std::uint32_t v) const {
    return v < first_listed_ ? nullptr : listed_[v - first_listed_];
  }
  [[nodiscard]] RationalPoint exact(std::uint32_t v) const {
    if (const RationalPoint* p = rational(v)) return *p;
    const Vertex& p = nearest(v);
    return to_rational(p);
  }
  [[nodiscard]] std::array<DoubleDouble, 3> fine(std::uint32_t v) const {
    if (const RationalPoint* p = rational(v))
      return {nearest_double_double((*p)[0]), nearest_double_double((*p)[1]), nearest_double_double((*p)[2])};
    const Vertex& p = nearest(v);
    return {p[0], p[1], p[2]};
  }

  /// True when two vertices have the same position.
  [[nodiscard]] static bool are_equal(const MeshPoints& a, std::uint32_t v, const MeshPoints& b, std::uint32_t w) {
    const Vertex &p = a.nearest(v), &q = b.nearest(w);
    if (p[0] != q[0] || p[1] != q[1] || p[2] != q[2]) return false;
    const RationalPoint *x = a.rational(v), *y = b.rational(w);
    if (x == nullptr && y == nullptr) return true;
    return x != nullptr && y != nullptr && *x == *y;
  }

 private:
  ExactMeshView mesh_;
  std::uint32_t first_listed_ = 0xffffffffu;
  std::vector<const RationalPoint*> listed_;  ///< from the first listed vertex on
};

}  // namespace strata
