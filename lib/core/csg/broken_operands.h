#pragma once
#include <span>

#include "strata/combine.h"
#include "strata/errors.h"

namespace strata {

/// Throws InputError for the first operand that was declared a solid and is none. Returns if there is no such operand.
void refuse_broken_operands(std::span<const Operand> operands, const Options& options);

/// The value of `evaluate()`. Where that finds what cannot be if all operands satisfy their input classes (LogicError),
/// operands that do not are refused as above.
template <class Evaluate>
auto refusing_broken_operands(std::span<const Operand> operands, const Options& options, const Evaluate& evaluate) {
  try {
    return evaluate();
  } catch (const LogicError&) {
    refuse_broken_operands(operands, options);
    throw;
  }
}

}  // namespace strata
