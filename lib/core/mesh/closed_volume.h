#pragma once
#include <optional>

#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/rational.h"

namespace strata {

struct ClosedVolume {
  double nearest = 0;
  std::optional<Rational> exact;  ///< where all vertices are doubles
};

/// The signed volume of a closed mesh, as `volume`; unspecified for others. The sum of the prisms between triangles and
/// the plane z = 0 takes a third of the products of the sum of determinants. It is computed where the coordinates are
/// on one lattice. O(n).
[[nodiscard]] ClosedVolume volume_of_closed(ExactMeshView mesh, const Monitor& monitor = {});

/// As `area`.
[[nodiscard]] double area_of(const ExactMesh& mesh, const Monitor& monitor);

}  // namespace strata
