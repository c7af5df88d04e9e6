#pragma once
#include <cstdint>

#include "strata/mesh.h"

namespace verify {

/// Where sheets of a closed surface touch, told so that it does not depend on the triangles.
///
/// A non-manifold edge is a straight stretch, as long as can be, along which the same number 2k > 2 of sheets meet. A
/// non-manifold vertex is a point, not inside such a stretch, about which the triangles form several fans (connected
/// over manifold edges).
///
/// An engine may list such a place once, or once for each sheet, or anything between. Each copy of an edge beyond the
/// first lowers the Euler characteristic by 1, each copy of a vertex raises it by 1. So that of an equal surface,
/// however it is split, lies between `euler - extra_edges` and `euler + extra_vertices`, and its components between
/// those of the welded surface and `parts`.
struct NonManifold {
  std::uint64_t edges = 0;
  std::uint64_t vertices = 0;
  std::uint64_t extra_edges = 0;     ///< sum of k - 1
  std::uint64_t extra_vertices = 0;  ///< sum of the fans beyond the first
  std::uint64_t parts = 0;           ///< connected over manifold edges

  friend bool operator==(const NonManifold&, const NonManifold&) = default;
};

/// Equal vertices count as one. Requires a closed mesh. O(n log n).
[[nodiscard]] NonManifold non_manifold(const strata::ExactMesh& mesh);

}  // namespace verify
