#pragma once
#include <cstdint>
#include <span>

#include "core/cells/cell_tree.h"
#include "core/cells/windings.h"
#include "core/kernel/point.h"
#include "core/winding/winding_oracle.h"

namespace strata {

/// Winding numbers at points, by the signed covering about local origins (Feito and Torres 1997): w(q) = w(O) + the
/// signs of the faces of q's cell that the walk from O to q crosses. These are the faces whose tetrahedron about O
/// contains q. No order of the faces is needed, so cyclic dominance is no obstacle. core/cells/theory.md.
class LocalWindings final : public WindingOracle {
 public:
  LocalWindings(const InputComplex& input, const CellTree& cells) : input_(input), cells_(cells) {}

  [[nodiscard]] Windings around(const Point& q, std::uint32_t own) const override;

  [[nodiscard]] Windings above(std::uint32_t face, const Point& q,
                               std::span<const std::uint32_t> covering) const override;

  [[nodiscard]] const CellTree* cells() const override { return &cells_; }

  /// Grid coordinates of a point, by its nearest doubles.
  [[nodiscard]] std::array<std::int32_t, 3> grid_of(const Point& q) const;

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  [[nodiscard]] GridBox box_of(std::uint32_t operand, std::uint32_t face) const;
  [[nodiscard]] Windings walk(const Point& q, std::uint32_t own, std::span<const std::uint32_t> through_q) const;

  const InputComplex& input_;
  const CellTree& cells_;
};

}  // namespace strata
