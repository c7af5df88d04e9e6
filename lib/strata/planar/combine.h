#pragma once
#include <stdexcept>

#include "strata/mesh/monitor.h"
#include "strata/planar/fill.h"
#include "strata/planar/region.h"

namespace strata::plane {

/// Loops, and what they fill.
struct Operand {
  const Loops* loops = nullptr;
  FillRule fill = FillRule::nonzero;

  Operand(const Loops& l, FillRule f = FillRule::nonzero) : loops(&l), fill(f) {}  // NOLINT: loops are an operand
  Operand(const Region& r) : loops(&r.loops) {}                                    // NOLINT: and so is a region
};

/// The combination holds outside of all operands, so that its set has no end.
class UnboundedResult : public std::runtime_error {
 public:
  UnboundedResult() : std::runtime_error("the combination holds outside of all operands: the result is unbounded") {}
};

/// The open regularization of a Boolean combination of the sets that the operands fill: its polygons. Exact for all
/// finite input. O((n + k) log n) for k points inside edges; one arrangement, whatever the number of operands. Laws:
/// those of Boolean algebra, up to regularization; the same for loops started elsewhere and for operands in another
/// order. Throws UnboundedResult, Cancelled.
[[nodiscard]] Region combine(std::span<const Operand> operands, Operation operation, const Monitor& monitor = {});
[[nodiscard]] Region combine(std::span<const Operand> operands, const Combination& combination,
                             const Monitor& monitor = {});

[[nodiscard]] Region unite(const Operand& a, const Operand& b);
[[nodiscard]] Region intersect(const Operand& a, const Operand& b);
[[nodiscard]] Region subtract(const Operand& a, const Operand& b);
[[nodiscard]] Region symmetric_difference(const Operand& a, const Operand& b);
/// The polygons of loops by themselves.
[[nodiscard]] Region fill(const Operand& a);

}  // namespace strata::plane
