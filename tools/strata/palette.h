#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

using Colour = std::array<std::uint8_t, 3>;

inline constexpr Colour grey{128, 128, 128};

/// The k-th of twelve colours, round and round: neighbours are easy to tell apart (Brewer, "Paired", bright ones
/// first).
[[nodiscard]] constexpr Colour palette_colour(std::size_t k) {
  constexpr std::array<Colour, 12> palette{{{227, 26, 28},
                                            {31, 120, 180},
                                            {51, 160, 44},
                                            {255, 127, 0},
                                            {106, 61, 154},
                                            {177, 89, 40},
                                            {251, 154, 153},
                                            {166, 206, 227},
                                            {178, 223, 138},
                                            {253, 191, 111},
                                            {202, 178, 214},
                                            {255, 255, 153}}};
  return palette[k % palette.size()];
}
