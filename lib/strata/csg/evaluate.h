#pragma once
#include "strata/csg/combine.h"
#include "strata/kernel/carriers.h"
#include "strata/mesh/monitor.h"
#include "strata/select/boundary.h"
#include "strata/select/rule.h"

namespace strata {

/// The whole pipeline on operands that are ready: cells -> overlap -> arrange -> layers -> select.
/// `self`: faces of one operand may meet each other, and winding numbers are whatever they are.
/// Vertices of different operands at one place are identified; constructed points become points of the table.
[[nodiscard]] Boundary evaluate(Carriers& carriers, const Rule& rule, bool self, PointTable& points,
                                const Monitor& monitor, Profile& profile);

}  // namespace strata
