#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "extensions/surface/walls.h"

namespace strata {

/// The cells into which walls divide space; number 0 is the unbounded one.
struct SpaceCells {
  std::uint32_t count = 1;
  std::vector<std::array<std::uint32_t, 2>> of_wall;  ///< in front of it, behind it
};

/// Found from the order of walls around every edge. Sides of walls that face each other across an angle at an edge
/// belong to one cell; sides connected in this way form a shell. A shell bounds a bounded cell from outside exactly
/// when its signed volume is positive, and every set of walls that is connected over edges has exactly one shell that
/// does not: that one lies in the innermost cell around the set, which a ray finds. theory.md, section 2. `mesh` is
/// that of the walls. O(n log n), and per connected set the walls of other sets that a ray from it meets.
[[nodiscard]] SpaceCells find_cells(const Walls& walls, const ExactMesh& mesh, const Monitor& monitor);

}  // namespace strata
