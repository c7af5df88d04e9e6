#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// Vertices with the same coordinates, as pairs, where faces may meet. Once they are identified, faces
/// that touch in them have a vertex in common, and solids that share faces share them by number: most of what
/// touching solids have in common is then no meeting at all. Rational vertices are left alone.
/// O(n) for n vertices, in parallel; which of three or more are paired depends on threads.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> find_coincidences(const InputComplex& input,
                                                                                     const CellTree& cells,
                                                                                     const Monitor& monitor);

}  // namespace strata
