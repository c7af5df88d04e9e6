#pragma once
#include <cstdint>
#include <span>

#include "core/kernel/input_complex.h"
#include "core/select/rule.h"
#include "core/winding/corner_cache.h"

namespace strata {

/// Decides that nothing of a face is kept, because one operand alone decides the rule there, as deep inside a union of
/// many. The winding number about an operand that the face does not meet is the same on all of the face; theory.md,
/// "Early out". For one thread.
class EarlyOut {
 public:
  EarlyOut(const InputComplex& input, const Rule& rule) : input_(input), rule_(rule), known_(input.vertex_count()) {}

  /// Starts with a face and the operands that it meets, its own included, in order.
  void start(const InputComplex::Indices& corners, std::span<const std::uint32_t> met) {
    corners_ = corners;
    met_ = met;
  }
  /// True if facts recorded at the face's corners decide.
  [[nodiscard]] bool is_settled();
  /// True if the winding numbers about all operands but its own, at a corner on no other surface, decide.
  [[nodiscard]] bool is_settled(const Windings& windings);
  /// Records winding numbers at a corner on no other surface.
  void tell(std::uint32_t corner, const Windings& windings);

 private:
  [[nodiscard]] bool meets(std::uint32_t operand) const;
  bool settle(std::uint32_t operand);

  const InputComplex& input_;
  const Rule& rule_;
  CornerCache<std::uint32_t> known_;  ///< an operand that decides all faces of the corner that do not meet it
  InputComplex::Indices corners_{};
  std::span<const std::uint32_t> met_;
};

}  // namespace strata
