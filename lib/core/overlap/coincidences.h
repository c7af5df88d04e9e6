#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// Pairs of vertices with equal coordinates, of faces that may meet others. After they are identified, faces that touch
/// in them have a vertex in common, and solids that share faces share them by number. Then most contacts of touching
/// solids are no intersections (theory.md, "Coincident vertices"). O(n) for n vertices, O(n log n) if any are rational,
/// in parallel. Which pairs of three or more equal vertices are returned depends on the threads.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> find_coincidences(const InputComplex& input,
                                                                                     const CellTree& cells,
                                                                                     const Monitor& monitor);

}  // namespace strata
