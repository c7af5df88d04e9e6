#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/csg/operand_box.h"
#include "strata/monitor.h"

namespace strata {

/// Operands of a union that have coincident faces with opposite orientation: pairs of faces with the same three
/// corners, such as the caps of the pieces of a sweep. Returns groups of operands connected by such faces, each in
/// order, of 2 to 32. A group of more than half of all operands is left out, because uniting it first gains nothing.
/// Rational corners are compared by their doubles: groups affect the speed, not the result. Throws Cancelled.
/// O(faces), expected.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> groups_with_coincident_facets(std::span<const Operand> operands,
                                                                                    std::span<const OperandBox> united,
                                                                                    const Monitor& monitor = {});

}  // namespace strata
