#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/cells/cell_tree.h"

namespace strata {

/// What does not hold of a subdivision of space; empty: nothing.
///
/// Of all cells: faces are listed by increasing number, with their boxes, which reach into the cell; only mixed cells
/// list any. Of a sample of faces: they are listed in the mixed cells in which their corners are, and unless they are
/// thinned in all that their boxes reach into. Of a sample of pairs that a cell lists: if their boxes overlap and
/// neither is thinned, the cell in which the lower corner of the intersection lies lists both and owns them. O(n) for n
/// listed faces.
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const CellTree& tree);

/// The first part of it: what each cell's list says of itself.
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, std::span<const Cell> cells);

}  // namespace strata
