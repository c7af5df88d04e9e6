#include "core/csg/resolved_operand.h"

#include <span>

namespace strata {

BooleanResult resolved_operand(const Operand& operand, const Options& options, std::uint32_t index) {
  Options alone = options;
  alone.engine = nullptr;
  alone.exact_vertices = true;
  alone.measure = false;
  alone.progress = {};
  try {
    return combine(Operation::union_, std::span(&operand, 1), alone);
  } catch (const InputError& error) {
    throw InputError(error.defects(), index);
  }
}

}  // namespace strata
