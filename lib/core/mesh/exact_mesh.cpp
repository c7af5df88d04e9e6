#include <algorithm>

#include "core/kernel/rational_point.h"
#include "strata/mesh.h"

namespace strata {

RationalPoint ExactMesh::position(std::uint32_t vertex) const { return ExactMeshView(*this).position(vertex); }

RationalPoint ExactMeshView::position(std::uint32_t vertex) const {
  const auto found = std::lower_bound(exact.begin(), exact.end(), vertex,
                                      [](const ExactVertex& e, std::uint32_t v) { return e.vertex < v; });
  if (found != exact.end() && found->vertex == vertex) return found->position;
  const Vertex& v = mesh.vertices[vertex];
  return to_rational(v);
}

}  // namespace strata
