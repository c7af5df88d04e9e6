#pragma once
#include <cstdint>
#include <vector>

#include "strata/attributes.h"

/// A picture as bytes: red, green, blue, row after row from the top.
struct ImagePixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The pixels of a PNG or JPEG image; what is transparent is seen on white. Throws std::runtime_error with the reason
/// where the image is neither, where it is damaged, has more than 2^26 pixels, or is of a kind that this program was
/// built without (STRATA_WITH_PNG, STRATA_WITH_JPEG). O(pixels).
[[nodiscard]] ImagePixels pixels_of(const strata::Image& image);
