#pragma once
#include "core/cells/grid.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// The space in which faces may meet, on a grid over all operands.
struct Space {
  Grid grid;
  GridBox interest{};                  ///< half-open: outside of it no operand is met by another
  InputComplex::Coordinates corner{};  ///< its lower corner
  double beyond = 0;                   ///< in the sense of walk.h, a point with this x is outside of every operand
  bool empty = true;                   ///< no two operands share any space
};

/// Bounds every operand and finds the space that the bounds of different ones share; all space if `self`.
/// One streaming pass.
[[nodiscard]] Space find_space(const InputComplex& input, bool self);

}  // namespace strata
