#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/embedded_stars.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Two faces of one mesh that share a point other than vertices and edges that both have.
struct SelfIntersection {
  std::uint32_t face = 0, other = 0;  ///< face < other
  bool is_coplanar = false;           ///< they overlap in one plane
  Vertex at{};                        ///< the doubles near one of their common points
};

/// One mesh that may cross itself, as input. Refers to the mesh.
[[nodiscard]] InputComplex complex_of(ExactMeshView mesh);
[[nodiscard]] inline InputComplex complex_of(MeshView mesh) { return complex_of(ExactMeshView(mesh, {})); }

/// The pairs of faces of the first operand that intersect, by their numbers. Requires finite coordinates, valid indices
/// and faces of positive area. Vertices are equal where their numbers are: `identify` has no effect here. `stars`: of
/// this mesh, if it is closed, else null; the result is the same, and found sooner. Exact: a pair is found if and only
/// if it is one. Ends when at least `enough` pairs are found, the same ones for any number of threads. O(n log n +
/// pairs whose boxes overlap), in parallel. Throws Cancelled.
[[nodiscard]] std::vector<SelfIntersection> find_self_intersections(
    const InputComplex& input, const EmbeddedStars* stars, const Monitor& monitor,
    std::size_t enough = std::numeric_limits<std::size_t>::max());

}  // namespace strata
