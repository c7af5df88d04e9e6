#pragma once
#include <cstdint>
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

  [[nodiscard]] bool at(std::uint32_t vertex) const {
    const std::uint32_t f = found_[vertex];
    const std::uint32_t met_once = f >> once & ~(f >> twice) & 7u;
    const std::uint32_t one_side = ~(f & f >> directions) & ((1u << directions) - 1);  // not seen from both sides
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      if ((one_side >> axis & 1u) != 0 && (met_once & ~(1u << axis)) != 0) return true;
      if ((one_side >> diagonals_across(axis) & 3u) != 0 && (met_once >> axis & 1u) != 0) return true;
    }
    return false;
  }

 private:
  friend class StarFinder;
  /// Of projection: the three axes, then per axis the two diagonals of the others.
  static constexpr std::uint32_t directions = 9;
  static constexpr std::uint32_t once = 2 * directions, twice = once + 3;
  static constexpr std::uint32_t diagonals_across(std::uint32_t axis) { return 3 + 2 * axis; }

  /// Per vertex: a bit per direction, set where a face is not certain to be seen from above; the same for below; then
  /// per axis, if the angle of one face contains the half-plane in which that coordinate is the vertex's (half open,
  /// one of the two there are), and if more than one does.
  std::vector<std::uint32_t> found_;
};

}  // namespace strata
