#pragma once
#include "core/kernel/input_complex.h"
#include "core/select/boundary.h"
#include "core/select/rule.h"
#include "core/select/split_faces.h"
#include "strata/combine.h"
#include "strata/options.h"

namespace strata {

/// What stays of all faces: the verdicts on those that meet no other, and the pieces of the others.
struct Evaluated {
  std::vector<Verdict> whole;    ///< per face; drop for those that are split
  std::vector<SplitFace> split;  ///< by increasing face; their arrays are in the pools
  Pools pools;
};

/// The pipeline on operands that are ready: cells -> overlap -> arrange -> layers -> select.
/// `self`: faces of one operand may meet each other, and winding numbers are whatever they are.
/// Vertices of different operands at one place are identified; constructed points become points of the table.
[[nodiscard]] Evaluated evaluate_pieces(InputComplex& input, const Rule& rule, bool self, PointTable& points,
                                        const Monitor& monitor, Profile& profile);

/// The same before pieces that stay together are merged, for callers that drop some of them first.
[[nodiscard]] Evaluated arrange_pieces(InputComplex& input, const Rule& rule, bool self, PointTable& points,
                                       const Monitor& monitor, Profile& profile);

/// evaluate_pieces, gathered into one boundary.
[[nodiscard]] Boundary evaluate(InputComplex& input, const Rule& rule, bool self, PointTable& points,
                                const Monitor& monitor, Profile& profile);

}  // namespace strata
