#pragma once
#include <cstdint>
#include <vector>

#include "strata/function.h"
#include "strata/mesh.h"

namespace strata {

/// A mesh with rational vertices as ExactMesh has them, but positions are computed when they are asked for. Refers to
/// the mesh, and to what `position` refers to.
struct NearestMesh {
  MeshView mesh;                       ///< each vertex at the doubles nearest to its position
  std::vector<std::uint32_t> rounded;  ///< vertices whose position is not three doubles, in increasing order
  Function<RationalPoint(std::uint32_t vertex)> position;  ///< of one of these; may be called from many threads

  /// The same mesh; refers to it.
  [[nodiscard]] static NearestMesh of(const ExactMesh& exact);
};

}  // namespace strata
