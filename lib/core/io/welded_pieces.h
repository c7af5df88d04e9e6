#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "strata/io.h"

namespace strata::io {

/// Triangles and their points; equal corners within the piece are one point.
template <class Scalar>
struct WeldedPiece {
  std::vector<std::array<Scalar, 3>> points;  ///< different ones, in order of first use
  std::span<Triangle> triangles;              ///< numbers of points
};

/// Welds equal points of different pieces. Vertices are numbered by first use, in the order of the pieces. `triangles`
/// owns the arrays to which the pieces refer. Triangles without three different vertices are left out and noted.
/// Requires at most 2^32 - 2 points in all. O(points + triangles) expected, in parallel.
///
/// A hash distributes points into partitions, each small enough for a core's cache and in the order of the pieces. A
/// table per partition finds the first use of every point. A count of first uses per piece numbers them.
template <class Scalar>
[[nodiscard]] MeshFile join(std::span<const WeldedPiece<Scalar>> pieces, std::vector<Triangle> triangles,
                            const std::string& name);

}  // namespace strata::io
