#pragma once
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/point_table.h"
#include "core/select/subdivide.h"
#include "strata/options.h"

namespace strata {

/// Merges pieces of one face that stay together: sides between them that bound no other piece go, so do constructed
/// vertices in which nothing but such sides met, and those that only divide a straight edge of the result. Faces
/// concerned are triangulated anew from their boundary loops; all others stay as they are.
///
/// Where two solids do nothing but cross (SubdividedFace::may_merge), every side and every constructed point bounds
/// what stays, and only points of other faces are looked at.
///
/// Whether a side or vertex is needed is decided for all faces at once, so the result meets only along shared edges and
/// vertices as before. Input vertices on boundary loops always stay: whole faces may use them.
void merge_pieces(const InputComplex& input, Subdivision& subdivision, const Monitor& monitor);

}  // namespace strata
