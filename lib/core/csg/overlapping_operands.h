#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/csg/operand_box.h"

namespace strata {

/// Operands of a union that crowd one another: each one's box overlaps those of most others, and of 16 at least. Much
/// of their surfaces is hidden in some other one, yet in one arrangement everything meets everything. Returns groups of
/// neighbours, of up to 13, to be united first; none where operands are spread. O(n^2) for n operands, of which there
/// may be up to 2,000.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groups_of_overlapping_operands(
    std::span<const OperandBox> united);

}  // namespace strata
