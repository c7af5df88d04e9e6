#pragma once
#include <cstdint>

#include "core/mesh/nearest_mesh.h"
#include "strata/function.h"
#include "strata/measure.h"
#include "strata/mesh.h"

namespace strata {

/// How the triangles of a mesh are connected.
struct Connections {
  Topology topology;
  std::uint64_t facets = 0;  ///< as in Measures; 0 if not asked for
};

enum class Facets : bool { skip, count };

/// Requires indices in range; to count facets, finite coordinates. O(n log d) for vertices of degree d, in parallel.
[[nodiscard]] Connections connections(ExactMeshView mesh, Facets facets, const Monitor& monitor = {});

/// The same, with facets. `are_coplanar`: of two triangles with a common edge, whose sides there have opposite
/// directions. May be called from many threads.
[[nodiscard]] Connections connections(const NearestMesh& mesh,
                                      FunctionRef<bool(std::uint32_t, std::uint32_t)> are_coplanar,
                                      const Monitor& monitor);

/// As `topology` of the exact mesh.
[[nodiscard]] Topology topology_of(const NearestMesh& mesh);

}  // namespace strata
