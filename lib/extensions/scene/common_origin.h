#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/winding/winding_oracle.h"
#include "extensions/scene/signed_covering.h"

namespace strata {

/// Winding numbers of several operands, each a solid with a covering about the same origin. The walk from the origin to
/// a point meets only faces that the coverings list in its direction.
class CommonOrigin final : public WindingOracle {
 public:
  /// The operands of `input` are the coverings' solids, in this order. Stores references.
  CommonOrigin(const InputComplex& input, std::span<const SignedCovering* const> coverings)
      : input_(input), coverings_(coverings.begin(), coverings.end()) {}

  [[nodiscard]] Windings around(const Point& q, std::uint32_t own) const override;
  [[nodiscard]] Windings above(std::uint32_t face, const Point& q,
                               std::span<const std::uint32_t> covering) const override;

 private:
  void walk(std::uint32_t operand, const Point& q, std::span<const std::uint32_t> through_q, Windings& windings) const;

  const InputComplex& input_;
  std::vector<const SignedCovering*> coverings_;
};

}  // namespace strata
