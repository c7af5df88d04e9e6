#pragma once
#include <cstdint>

namespace strata {

/// The place of a cell on a Z-curve through 1024 cells each way: bits of x, y and z in turn, those of x first. Cells
/// near each other on the curve are near each other in space. Requires numbers below 1024. Source: Morton 1966.
[[nodiscard]] constexpr std::uint32_t z_order(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  const auto every_third = [](std::uint32_t bits) {
    bits = (bits | bits << 16) & 0x30000ff;
    bits = (bits | bits << 8) & 0x300f00f;
    bits = (bits | bits << 4) & 0x30c30c3;
    return (bits | bits << 2) & 0x9249249;
  };
  return every_third(x) << 2 | every_third(y) << 1 | every_third(z);
}

}  // namespace strata
