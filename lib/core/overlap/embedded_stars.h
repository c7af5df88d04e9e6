#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/input_complex.h"
#include "strata/monitor.h"

namespace strata {

/// Vertices of a closed mesh around which nothing can cross: no two faces with such a vertex in common share a point
/// other than that vertex and an edge that both have.
///
/// The proof is a projection: along an axis, or along the diagonal of two. If all faces around a vertex are seen from
/// the same side, their angles there are positive and below 180 degrees. The mesh is closed, so each ray that starts at
/// the vertex is met equally often; if one is met once, all are, and the faces lie side by side. Signs of normals are
/// decided in doubles: a vertex is left out where these are not certain, where a face has a vertex that is rational, or
/// where no direction serves, as at the corners of a cube. theory.md, "Intersections of one mesh with itself".
class EmbeddedStars {
 public:
  /// Of the first operand. Requires a closed chain of faces with valid indices. O(n), in parallel.
  EmbeddedStars(const InputComplex& input, const Monitor& monitor);

  /// For a part of the mesh. `vertices`: the number here of each of its vertices.
  [[nodiscard]] EmbeddedStars of_part(std::span<const std::uint32_t> vertices) const;
  /// For a mesh of `count` vertices of which this is a part. `vertices`: the mesh's number of each vertex of the part;
  /// `equal`: vertices of the mesh that are in the place of another one, and that one.
  [[nodiscard]] EmbeddedStars of_whole(std::size_t count, std::span<const std::uint32_t> vertices,
                                       std::span<const std::pair<std::uint32_t, std::uint32_t>> equal) const;

  [[nodiscard]] bool at(std::uint32_t vertex) const { return is_embedded_[vertex] != 0; }

  /// The faces around a vertex change: nothing is known of them any more. Thread-safe beside other calls of itself.
  void forget(std::uint32_t vertex) { std::atomic_ref(is_embedded_[vertex]).store(0, std::memory_order_relaxed); }
  /// A vertex that no face has yet.
  void add_vertex() { is_embedded_.push_back(0); }

 private:
  EmbeddedStars() = default;

  std::vector<char> is_embedded_;  ///< per vertex
};

}  // namespace strata
