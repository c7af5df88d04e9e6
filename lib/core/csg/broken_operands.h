#pragma once
#include <span>

#include "strata/combine.h"

namespace strata {

/// Called when a result shows that an operand does not satisfy its input class. Throws InputError for the first operand
/// that was declared a solid and is none. Returns if there is no such operand.
void refuse_broken_operands(std::span<const Operand> operands, const Options& options);

}  // namespace strata
