#pragma once
#include <algorithm>
#include <cstdint>

#include "core/kernel/rational_point.h"
#include "strata/planar.h"
#include "strata/rational.h"
#include "strata/solid.h"

namespace strata {

/// Exact positions of a mesh's vertices by number.
class Positions {
 public:
  explicit Positions(const ExactMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] const Vertex& rounded(std::uint32_t v) const { return mesh_.mesh.vertices[v]; }
  /// The exact position of a vertex that is not three doubles, or null.
  [[nodiscard]] const RationalPoint* rational(std::uint32_t v) const {
    if (mesh_.exact.empty()) return nullptr;
    const auto at = std::lower_bound(mesh_.exact.begin(), mesh_.exact.end(), v,
                                     [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
    return at != mesh_.exact.end() && at->vertex == v ? &at->position : nullptr;
  }
  [[nodiscard]] RationalPoint exact(std::uint32_t v) const {
    if (const RationalPoint* p = rational(v)) return *p;
    const Vertex& p = rounded(v);
    return to_rational(p);
  }

 private:
  const ExactMesh& mesh_;
};

}  // namespace strata
