#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/csg/operand_box.h"

namespace strata {

/// Operands of a union that have walls in common: pairs of faces with the same three corners that look opposite ways,
/// as the caps of pieces that a sweep was made of. Returns groups of operands connected by such walls, each in order,
/// of 2 to 32. A group that would be most of all operands is left out, since nothing is gained. Rational corners are
/// compared by their doubles: groups are a matter of speed, not of the result. O(faces), expected.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groups_with_coincident_facets(std::span<const Operand> operands,
                                                                                    std::span<const OperandBox> united);

}  // namespace strata
