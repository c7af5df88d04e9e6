#pragma once
#include "strata/planar/region.h"

namespace strata::plane {

/// The canonical decomposition SGC(S) of the plane by a polygon S (source document, 3.2): the face S, the exterior
/// faces, and the boundary's edges and vertices, which the polygon determines. A vertex is a boundary point around
/// which the boundary is no straight line; edges are the components of the rest. Labels: S true, all else false.
struct CanonicalDecomposition {
  struct Edge {
    std::uint32_t from = 0, to = 0;  ///< in `vertices`; S lies to the left
  };
  std::vector<RationalPlacement> vertices;  ///< in lexicographic order
  std::vector<std::uint32_t> degree;        ///< edges at every vertex: 2 where the polygon is manifold
  std::vector<Edge> edges;
  std::uint32_t exterior_faces = 1;  ///< the unbounded one, and one in every hole

  [[nodiscard]] bool is_manifold() const;
};

[[nodiscard]] CanonicalDecomposition canonical_decomposition(const Region& region, std::uint32_t polygon);

}  // namespace strata::plane
