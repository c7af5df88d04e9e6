#pragma once
/// What is computed, of what, how, and how it is watched.
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "strata/errors.h"

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

struct Options {
  InputClass input = InputClass::solid;
  const Engine* engine = nullptr;             ///< none: the arrangement, which is what formulas need
  unsigned threads = 0;                       ///< 0: all cores. The result does not depend on it.
  bool exact_vertices = false;                ///< fill BooleanResult::exact (rationals; costs time per new vertex)
  std::function<void(double)> progress = {};  ///< called with a fraction 0..1, from any thread, never concurrently
  const std::atomic<bool>* cancel = nullptr;  ///< set to true to stop: throws Cancelled within milliseconds
};

/// Lets a long computation be cancelled and watched from outside. Holds references to what the caller owns.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(const std::atomic<bool>* cancel, const std::function<void(double)>* progress = nullptr)
      : cancel_(cancel), progress_(progress) {}

  /// Throws Cancelled once the caller has asked for it.
  void check() const {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) throw Cancelled("cancelled by the caller");
  }

  /// Tells how far the work is, 0 to 1. To be called between stages, never from two threads at once.
  void report(double fraction) const {
    if (progress_ != nullptr && *progress_) (*progress_)(fraction);
  }

 private:
  const std::atomic<bool>* cancel_ = nullptr;
  const std::function<void(double)>* progress_ = nullptr;
};

}  // namespace strata
