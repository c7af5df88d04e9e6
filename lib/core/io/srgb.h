#pragma once
#include <array>
#include <cstdint>

namespace strata::io {

/// The linear value, from 0 to 1, of a byte of an sRGB colour (IEC 61966-2-1).
[[nodiscard]] double linear_of_srgb(std::uint8_t byte);
/// The byte that is nearest to a linear value; of linear_of_srgb(b) it is b.
[[nodiscard]] std::uint8_t srgb_of_linear(double linear);
/// The byte nearest to a value from 0 to 1.
[[nodiscard]] std::uint8_t byte_of(double value);

}  // namespace strata::io
