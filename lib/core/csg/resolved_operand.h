#pragma once
#include <cstdint>

#include "strata/combine.h"

namespace strata {

/// The solid that an operand represents: its union with the empty solid, by the arrangement, with exact vertices. It
/// does not cross itself. Its sources are the operand's faces, under operand 0. Throws InputError that names operand
/// `index`.
[[nodiscard]] BooleanResult resolved_operand(const Operand& operand, const Options& options, std::uint32_t index);

}  // namespace strata
