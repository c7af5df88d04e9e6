#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/input_complex.h"
#include "strata/monitor.h"

namespace strata {

/// Vertices of a closed mesh around which nothing can cross: no two faces with such a vertex in common share a point
/// other than that vertex and an edge that both have.
///
/// The proof is a projection along an axis. If all faces around a vertex are seen from the same side, their angles
/// there are positive and below 180 degrees. The mesh is closed, so each ray that starts at the vertex is met equally
/// often; if one is met once, all are, and the faces lie side by side. Signs of normals are decided in doubles: a
/// vertex is left out where these are not certain, where a face has a vertex that is rational, or where no axis serves,
/// as at the corners of a cube.
class EmbeddedStars {
 public:
  /// Of the first operand. Requires a closed chain of faces with valid indices. O(n), in parallel.
  EmbeddedStars(const InputComplex& input, const Monitor& monitor);

  [[nodiscard]] bool at(std::uint32_t vertex) const {
    const std::uint32_t f = found_[vertex];
    const std::uint32_t one_side = ~(f & f >> 3);  // per axis: not seen from both sides
    return (one_side & f >> 6 & ~(f >> 9) & 7u) != 0;
  }

 private:
  /// Per vertex, a bit per axis in each of four groups: a face is not certain to be seen from above; from below; the
  /// ray of the axis is met; it is met more than once.
  std::vector<std::uint32_t> found_;
};

}  // namespace strata
