#pragma once
#include <array>

#include "strata/mesh.h"

namespace strata::io {

/// The outward unit normal as STL files carry it: rounded, for display only; 0 when rounding leaves no direction.
[[nodiscard]] std::array<float, 3> face_normal(MeshView mesh, const Triangle& triangle);

}  // namespace strata::io
