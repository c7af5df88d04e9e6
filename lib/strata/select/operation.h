#pragma once

namespace strata {

/// Regularized set operations on n >= 1 operands.
/// unite: in any; intersect: in all; subtract: in the first and in no other; exclude: in an odd number (xor).
enum class Operation { unite, intersect, subtract, exclude };

}  // namespace strata
