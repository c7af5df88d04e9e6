#pragma once
#include <cstdint>
#include <vector>

#include "strata/function.h"
#include "strata/mesh.h"

namespace strata {

/// A mesh with rational vertices as ExactMesh has them, but positions are compared only when this is asked for. Refers
/// to the mesh, and to what `are_equal` refers to.
struct NearestMesh {
  MeshView mesh;                       ///< each vertex at the doubles nearest to its position
  std::vector<std::uint32_t> rounded;  ///< vertices whose position is not three doubles, in increasing order
  /// Whether two of these have one position. May be called from many threads.
  Function<bool(std::uint32_t a, std::uint32_t b)> are_equal;

  /// The same mesh; refers to it.
  [[nodiscard]] static NearestMesh of(const ExactMesh& exact);
};

}  // namespace strata
