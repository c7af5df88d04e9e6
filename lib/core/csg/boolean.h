#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/mesh/prepare.h"
#include "core/overlap/self_intersections.h"
#include "core/select/rule.h"
#include "strata/combine.h"

namespace strata {

/// Where faces of the only operand intersect, after its preparation, on the first of equal vertices: if who asks has
/// found it already.
using KnownCrossings = std::optional<SelfCrossings>;

/// What is known of operands before a Boolean of them.
struct KnownOperands {
  KnownCrossings crossings;
  std::vector<std::optional<Prepared>> prepared;  ///< what preparation makes of each operand; none: nothing is known
};

/// The Boolean itself, stage by stage, in the current task arena:
///
/// | stage             | in -> out                    | what it does                                        |
/// |-------------------|------------------------------|-----------------------------------------------------|
/// | `prepare`         | operands -> input complex    | checks or repairs operands, numbers all faces       |
/// | `find_candidates` | input complex -> cells       | sorts faces that may meet into cells                |
/// | `intersect`       | cells -> constraints, points | intersects the pairs of faces in each cell          |
/// | `subdivide`       | constraints -> pieces        | triangulates the faces that meet, labels each piece |
/// | `label`           | pieces -> verdicts           | finds winding numbers of faces that meet no other   |
/// | `extract`         | pieces, verdicts -> boundary | merges pieces, numbers vertices and triangles       |
/// | `round`           | boundary -> mesh             | rounds constructed points to the nearest double     |
///
/// Every stage takes values and returns a value. All decisions are made before `round`. The names are those of
/// Profile::seconds; the lap `validate`, before `round`, ensures that the boundary is closed.
/// Throws as `combine` does.
[[nodiscard]] BooleanResult boolean(const Rule& rule, std::span<const Operand> given, const Options& options,
                                    KnownOperands known = {});

/// The stages after `prepare` for one closed mesh of any orientation, with exact vertices. Requires faces of positive
/// area. Throws Cancelled.
[[nodiscard]] BooleanResult resolved(InputComplex input, Inside inside, const Monitor& monitor);

}  // namespace strata
