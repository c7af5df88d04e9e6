#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/mesh/prepare.h"
#include "strata/combine.h"

namespace strata {

/// Operands that satisfy their input class, after repair where the class is `repair`. Refers to the arrays of the given
/// operands.
class PreparedOperands {
 public:
  /// `known`: what preparation makes of each operand, where that is known; empty: of none. Throws InputError that
  /// names the operand.
  PreparedOperands(std::span<const Operand> given, const Options& options, std::vector<std::optional<Prepared>> known);

  /// All operands in one numbering. Refers to this object. Winding numbers of a `solid` are 0 and 1, so its faces are
  /// not compared with each other.
  [[nodiscard]] InputComplex complex() const;
  /// The defects that were resolved, operand by operand.
  [[nodiscard]] std::vector<Defect> notes() const;
  /// Replaces face numbers of prepared operands by those of the given operands. In parallel.
  void restore(std::vector<Source>& sources) const;

 private:
  std::span<const Operand> given_;
  InputClass input_;
  std::vector<Prepared> prepared_;
};

}  // namespace strata
