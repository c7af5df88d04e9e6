#pragma once
#include <array>

#include "strata/mesh.h"
#include "support/random.h"

namespace strata::test {

/// The same solid in more triangles: edges divided in their middles, triangles at points inside, where chance has it.
/// Where a new vertex would have to be rounded there is none. O(steps * triangles).
[[nodiscard]] Mesh subdivided(Mesh mesh, Random& random, int steps);

/// The surface of a box of integers in squares of side 1, each divided along one diagonal or the other.
[[nodiscard]] Mesh box_in_squares(const std::array<int, 3>& lower, const std::array<int, 3>& upper,
                                  bool other_diagonal);

}  // namespace strata::test
