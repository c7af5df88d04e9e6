#pragma once
#include <cstdint>
#include <vector>

#include "strata/exact/rational.h"
#include "strata/mesh/mesh.h"

namespace strata {

/// The exact place of one vertex whose coordinates are not three doubles.
struct ExactVertex {
  std::uint32_t vertex = 0;
  RationalPoint position;
};

/// A triangle mesh whose vertices are rationals. `mesh` holds every coordinate rounded to the nearest double;
/// `exact` lists the vertices for which that changed something, in increasing order of index.
struct ExactMesh {
  Mesh mesh;
  std::vector<ExactVertex> exact;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size()).
};

}  // namespace strata
