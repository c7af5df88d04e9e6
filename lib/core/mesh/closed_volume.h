#pragma once
#include <cstddef>
#include <optional>

#include "core/mesh/split_vertices.h"
#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/rational.h"

namespace strata {

/// The exact volume is told where no more vertices are rational: a fraction has about a hundred digits for each.
inline constexpr std::size_t most_rational_vertices = 1000;

struct ClosedVolume {
  double nearest = 0;
  std::optional<Rational> exact;  ///< where few vertices are rational
};

/// The signed volume of a closed mesh, as `volume`; unspecified for others. The sum of the prisms between triangles and
/// the plane z = 0 takes a third of the products of the sum of determinants. It is computed where the coordinates are
/// on one lattice. O(n).
[[nodiscard]] ClosedVolume volume_of_closed(ExactMeshView mesh, const Monitor& monitor = {});

/// As `area`.
[[nodiscard]] double area_of(ExactMeshView mesh, const Monitor& monitor);

/// Is it known that a mesh is closed?
enum class Closed : bool { unknown, known };

/// As `nearest_volume` and `area` of a mesh whose vertices are sums of two doubles; none where these do not decide.
/// Where it is known that the mesh is closed, the volume is found sooner.
[[nodiscard]] std::optional<double> decided_volume(MeshView mesh, const SplitVertices& split, Closed closed,
                                                   const Monitor& monitor);
[[nodiscard]] std::optional<double> decided_area(MeshView mesh, const SplitVertices& split, const Monitor& monitor);

}  // namespace strata
