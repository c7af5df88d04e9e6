#pragma once
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/point_table.h"
#include "core/select/subdivide.h"
#include "strata/options.h"

namespace strata {

/// Merges kept pieces of one face with the same verdict. Sides between them that bound no other piece are removed. So
/// are constructed vertices at which only such sides met, and those that only divide a straight edge of the result. The
/// faces concerned are triangulated again from their boundary loops; all others are unchanged.
///
/// Where two solids only cross (SubdividedFace::may_merge), every side and every constructed point bounds a kept piece,
/// so only points of other faces are examined.
///
/// Whether a side or vertex is needed is decided for all faces together, so the result still meets only along shared
/// edges and vertices. Input vertices on boundary loops are always kept: whole faces may use them.
void merge_pieces(const InputComplex& input, Subdivision& subdivision, const Monitor& monitor);

}  // namespace strata
