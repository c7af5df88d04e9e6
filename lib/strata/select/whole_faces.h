#pragma once
#include <cstdint>
#include <vector>

#include "strata/layers/local_layers.h"
#include "strata/mesh/monitor.h"
#include "strata/select/rule.h"

namespace strata {

/// Verdicts on the faces that meet no other: such a face lies on one side of every other operand, and any point of it
/// tells. `touched[f]` marks the faces to leave out; theirs stays `drop`.
[[nodiscard]] std::vector<Verdict> judge_whole_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                                     const std::vector<std::uint8_t>& touched, bool self,
                                                     const Monitor& monitor);

}  // namespace strata
