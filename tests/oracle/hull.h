#pragma once
#include <span>

#include "strata/mesh.h"

namespace strata::oracle {

/// A convex hull as CGAL has it.
struct Hull {
  int dimension = 0;
  Mesh mesh;  ///< the corners, and below dimension 3 no triangles
};

/// CGAL's convex_hull_3 with exact predicates and constructions. At least one point.
[[nodiscard]] Hull convex_hull(std::span<const Vertex> points);

}  // namespace strata::oracle
