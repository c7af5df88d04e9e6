#pragma once
#include <memory>
#include <span>
#include <vector>

#include "strata/mesh.h"

namespace strata::oracle {

/// CGAL's Side_of_triangle_mesh on the exact predicates of EPICK: +1 inside, 0 on the boundary, -1 outside.
[[nodiscard]] std::vector<int> sides_of_mesh(const Mesh& mesh, std::span<const Vertex> points);

}  // namespace strata::oracle
