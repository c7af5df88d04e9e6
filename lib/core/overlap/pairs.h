#pragma once
#include "core/cells/cell_tree.h"
#include "core/overlap/constraint.h"
#include "strata/options.h"

namespace strata {

/// All constraints, grouped by face: those of one face are adjacent, in a fixed order.
/// Every pair of faces of different operands (with `self`: of any operands) is tested in exactly one cell: the one that
/// holds the lower corner of the intersection of their boxes. The same for any number of threads.
/// Constructed points become points of the table.
[[nodiscard]] Intersections find_intersections(const InputComplex& input, const CellTree& cells, bool self,
                                               PointTable& points, const Monitor& monitor);

}  // namespace strata
