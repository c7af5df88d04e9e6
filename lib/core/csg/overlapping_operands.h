#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/csg/operand_box.h"

namespace strata {

/// Mutually overlapping operands of a union: each one's box overlaps those of most others, and of at least 16. Much of
/// their surfaces is hidden inside other operands, yet in one arrangement every face meets many others. Returns groups
/// of neighbours, of up to 13, to be united first. There are none where operands overlap few others. O(n^2) for n
/// operands, at most 2,000.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groups_of_overlapping_operands(
    std::span<const OperandBox> united);

}  // namespace strata
