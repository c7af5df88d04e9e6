#pragma once
#include <cstdint>
#include <span>

#include "core/kernel/input_complex.h"

namespace strata {

/// True when faces, listed in order, belong to two operands, and a plane is found that has those of one strictly on one
/// side and those of the other on the other side. Then no two of them meet. Only a plane along the first operand's
/// faces is tried: it tells two surfaces that are nearly parallel from each other. Certain, also where the corners are
/// rationals. O(faces), in doubles.
[[nodiscard]] bool are_apart(const InputComplex& input, std::span<const std::uint32_t> faces);

}  // namespace strata
