#pragma once
#include <cstdint>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/select/rule.h"
#include "core/select/split_faces.h"
#include "core/winding/winding_oracle.h"
#include "strata/options.h"

namespace strata {

/// Verdicts on the faces that meet no other: such a face lies on one side of every other operand, and any point of it
/// tells. `split` are the faces to leave out, by increasing number; theirs stays `drop`. `cells`, if there are any that
/// know the windings at their origins, answer for the faces in regions.
[[nodiscard]] std::vector<Verdict> judge_whole_faces(const InputComplex& input, const WindingOracle& oracle,
                                                     const CellTree* cells, const Rule& rule,
                                                     const std::vector<SplitFace>& split, bool self,
                                                     const Monitor& monitor);

}  // namespace strata
