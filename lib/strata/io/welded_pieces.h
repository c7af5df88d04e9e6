#pragma once
#include <array>
#include <span>
#include <vector>

#include "strata/mesh/mesh.h"

namespace strata::io {

/// Triangles whose equal corners are one point, within the piece.
template <class Scalar>
struct WeldedPiece {
  std::vector<std::array<Scalar, 3>> points;  ///< different ones, in order of first use
  std::span<Triangle> triangles;              ///< numbers of points
};

/// Makes equal points of different pieces one vertex. Vertices are numbered by first use, in the order of the pieces;
/// the triangles get these numbers. Returns the vertices. Requires at most 2^32 - 2 points in all. O(points +
/// triangles) expected, in parallel.
///
/// Points are dealt into partitions by hash, each small enough for a core's cache and in the order of the pieces. A
/// table per partition finds the first use of every point; counting first uses per piece numbers them.
template <class Scalar>
[[nodiscard]] std::vector<Vertex> join(std::span<const WeldedPiece<Scalar>> pieces);

}  // namespace strata::io
