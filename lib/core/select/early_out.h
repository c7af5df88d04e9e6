#pragma once
#include <cstdint>
#include <span>

#include "core/kernel/input_complex.h"
#include "core/select/rule.h"
#include "core/winding/corner_cache.h"

namespace strata {

/// Tells faces of which nothing stays because of one operand alone, deep inside a union of many, say. An operand that a
/// face does not meet is everywhere along the face what it is at one corner; theory.md, "Settled faces". For one
/// thread.
class EarlyOut {
 public:
  EarlyOut(const InputComplex& input, const Rule& rule) : input_(input), rule_(rule), known_(input.vertex_count()) {}

  /// Looks at a face and the operands it meets, its own included, in order.
  void start(const InputComplex::Indices& corners, std::span<const std::uint32_t> met) {
    corners_ = corners;
    met_ = met;
  }
  /// By what was found out at the face's corners before.
  [[nodiscard]] bool is_settled();
  /// By the winding numbers about all operands but its own at a corner on no other surface.
  [[nodiscard]] bool is_settled(const Windings& windings);
  /// Remembers winding numbers around a corner on no other surface.
  void tell(std::uint32_t corner, const Windings& windings);

 private:
  [[nodiscard]] bool meets(std::uint32_t operand) const;
  bool settle(std::uint32_t operand);

  const InputComplex& input_;
  const Rule& rule_;
  CornerCache<std::uint32_t> known_;  ///< an operand that settles all faces of the corner that do not meet it
  InputComplex::Indices corners_{};
  std::span<const std::uint32_t> met_;
};

}  // namespace strata
