#pragma once
#include <span>
#include <vector>

#include "core/csg/boolean.h"
#include "strata/combine.h"

namespace strata {

/// What operands of class `automatic` turn out to be.
struct FoundClass {
  InputClass input = InputClass::solid;  ///< or `overlapping`, if one of them crosses itself or has a shell in a shell
  std::vector<Defect> notes;             ///< what there is to resolve
  KnownOperands known;                   ///< found on the way
};

/// Inspects operands, unless they are known to bound solids. Runs in the current task arena. Throws InputError, which
/// names the operand, for one that is not closed, and Cancelled. Complexity: Inspection. `facts`: of the mesh of the
/// only operand, if known.
[[nodiscard]] FoundClass find_class(std::span<const Operand> operands, const Monitor& monitor,
                                    const Screening* facts = nullptr);

}  // namespace strata
