#pragma once
#include "strata/mesh.h"

namespace strata::oracle {

/// True when no two triangles share a point other than vertices with the same coordinates and the edges between them,
/// by CGAL's intersections of boxes and its exact predicates.
[[nodiscard]] bool is_embedded(const Mesh& mesh);

}  // namespace strata::oracle
