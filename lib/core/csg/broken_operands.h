#pragma once
#include <span>

#include "strata/combine.h"

namespace strata {

/// To be called when a result shows that an operand was not what was declared: throws InputError for the first operand,
/// declared a solid, that is none. Returns when all are.
void refuse_broken_operands(std::span<const Operand> operands, const Options& options);

}  // namespace strata
