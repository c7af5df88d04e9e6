#pragma once
#include "strata/csg/combine.h"
#include "strata/kernel/carriers.h"
#include "strata/mesh/monitor.h"
#include "strata/select/boundary.h"
#include "strata/select/rule.h"

namespace strata {

/// The whole pipeline on operands that are ready: cells -> overlap -> arrange -> layers -> select.
/// `self`: faces of one operand may meet each other, and winding numbers are whatever they are.
[[nodiscard]] Boundary evaluate(Carriers carriers, const Rule& rule, bool self, const Monitor& monitor,
                                Profile& profile);

}  // namespace strata
