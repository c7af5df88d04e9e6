#pragma once
#include <span>

#include "strata/mesh.h"

namespace bench {

/// Seconds it takes one thread to copy the arrays of all these meshes into memory that was never touched: the least
/// that any program spends which reads its input and writes its output. Median of five.
[[nodiscard]] double copy_floor(std::span<const strata::MeshView> meshes);

/// Bytes in the arrays of a mesh.
[[nodiscard]] std::size_t array_bytes(const strata::MeshView& mesh);

}  // namespace bench
