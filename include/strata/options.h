#pragma once
/// What is computed, of what, how, and how it is watched.
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "strata/errors.h"
#include "strata/monitor.h"

namespace strata {

/// Regularized set operations on n >= 1 operands.
/// union_: in any; intersection: in all; difference: in the first and in no other; symmetric_difference: in an odd
/// number.
enum class Operation { union_, intersection, difference, symmetric_difference };

inline constexpr std::array all_operations{Operation::union_, Operation::intersection, Operation::difference,
                                           Operation::symmetric_difference};

/// Its name, in files and on the command line: union, intersection, difference, symmetric-difference.
[[nodiscard]] constexpr const char* name(Operation operation) {
  constexpr std::array names{"union", "intersection", "difference", "symmetric-difference"};
  return names[static_cast<std::size_t>(operation)];
}

/// The operation of that name, or of the short name xor; none if there is no such operation.
[[nodiscard]] constexpr std::optional<Operation> operation_named(std::string_view text) {
  for (const Operation operation : all_operations)
    if (text == name(operation)) return operation;
  if (text == "xor") return Operation::symmetric_difference;
  return std::nullopt;
}

/// Its sign in expressions: | & - ^.
[[nodiscard]] constexpr char sign(Operation operation) {
  constexpr std::array signs{'|', '&', '-', '^'};
  return signs[static_cast<std::size_t>(operation)];
}

/// What the caller declares about the operands.
enum class InputClass {
  solid,        ///< closed, winding numbers 0 and 1: the edge chain is checked, self-intersection is not searched
  overlapping,  ///< closed, may cross itself: resolved completely; inside is winding number > 0
  repair,       ///< a soup: weld equal vertices, drop duplicate and degenerate faces, orient; then as overlapping
};

inline constexpr std::array all_input_classes{InputClass::solid, InputClass::overlapping, InputClass::repair};

/// As it is written in files and on the command line: solid, overlapping, repair.
[[nodiscard]] constexpr const char* name(InputClass input) {
  constexpr std::array names{"solid", "overlapping", "repair"};
  return names[static_cast<std::size_t>(input)];
}

struct Engine;  // combine.h

/// How an operation is computed. Every field has a default: `{.threads = 1}` is enough.
struct Options {
  InputClass input = InputClass::solid;
  const Engine* engine = nullptr;       ///< null: the arrangement, which also evaluates every formula
  unsigned threads = 0;                 ///< 0: all cores. The result does not depend on it.
  bool exact_vertices = false;          ///< fill BooleanResult::exact (rationals; costs time per new vertex)
  Progress progress = {};               ///< any callable that takes a double: the fraction done
  const CancelToken* cancel = nullptr;  ///< null: the operation cannot be cancelled
};

}  // namespace strata
