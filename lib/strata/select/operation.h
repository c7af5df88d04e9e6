#pragma once
#include <array>
#include <cstddef>

namespace strata {

/// Regularized set operations on n >= 1 operands.
/// unite: in any; intersect: in all; subtract: in the first and in no other; exclude: in an odd number (xor).
enum class Operation { unite, intersect, subtract, exclude };

inline constexpr std::array all_operations{Operation::unite, Operation::intersect, Operation::subtract,
                                           Operation::exclude};

/// What people call it: union, intersection, difference, xor.
[[nodiscard]] constexpr const char* name(Operation operation) {
  constexpr std::array names{"union", "intersection", "difference", "xor"};
  return names[static_cast<std::size_t>(operation)];
}

/// Its sign in expressions: | & - ^.
[[nodiscard]] constexpr char sign(Operation operation) {
  constexpr std::array signs{'|', '&', '-', '^'};
  return signs[static_cast<std::size_t>(operation)];
}

}  // namespace strata
