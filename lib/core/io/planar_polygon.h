#pragma once
#include <span>

#include "strata/mesh.h"

namespace strata::io {

/// True when all vertices lie in one plane. Exact. O(n).
[[nodiscard]] bool is_planar(std::span<const Vertex> loop);

}  // namespace strata::io
