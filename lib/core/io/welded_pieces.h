#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "strata/io.h"

namespace strata::io {

/// Triangles whose equal corners are one point, within the piece.
template <class Scalar>
struct WeldedPiece {
  std::vector<std::array<Scalar, 3>> points;  ///< different ones, in order of first use
  std::span<Triangle> triangles;              ///< numbers of points
};

/// Makes equal points of different pieces one vertex. Vertices are numbered by first use, in the order of the pieces.
/// `triangles` owns what the pieces look at. Triangles without three different vertices are left out and noted.
/// Requires at most 2^32 - 2 points in all. O(points + triangles) expected, in parallel.
///
/// Points are dealt into partitions by hash, each small enough for a core's cache and in the order of the pieces. A
/// table per partition finds the first use of every point; counting first uses per piece numbers them.
template <class Scalar>
[[nodiscard]] MeshFile join(std::span<const WeldedPiece<Scalar>> pieces, std::vector<Triangle> triangles,
                            const std::string& name);

}  // namespace strata::io
