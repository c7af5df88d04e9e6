#pragma once
#include <array>

#include "strata/mesh.h"

namespace strata::io {

/// The outward unit normal as stored in STL files: rounded, for display only; 0 when it cannot be computed in doubles.
[[nodiscard]] std::array<float, 3> face_normal(MeshView mesh, const Triangle& triangle);

}  // namespace strata::io
