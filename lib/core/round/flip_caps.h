#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "core/round/moving_mesh.h"

namespace strata {

/// Needles, each lower than some units, side by side.
enum class Bundles { as_they_are, put_in_order };

/// Flips wrong faces that are caps, those whose height over their longest side is at most `reach` units, with a
/// neighbour across that side. A flip can make another cap, so there are some passes.
///
/// In a bundle, such flips go to and fro. To put it in order, between passes as above, is to flip two faces that both
/// lie within `reach` units of the line of their common side only if that side becomes shorter, until there are no such
/// flips.
///
/// The chain stays closed; a flip moves the surface by the height of the cap. Returns whether anything changed. The
/// same for any number of threads. O(n + k log k) for each pass over k wrong faces among n, of at most 36.
[[nodiscard]] bool flip_caps(MovingMesh& mesh, const std::vector<std::uint32_t>& wrong, const GridRounding& grid,
                             double reach, Bundles bundles);

}  // namespace strata
