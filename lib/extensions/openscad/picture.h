#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace strata::openscad {

/// Whether bytes begin as those of PNG files do.
[[nodiscard]] bool is_png(const std::string& bytes);

/// The colours of a picture: three bytes a pixel, red, green and blue, row by row from above.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<unsigned char> colours;
};

/// Decodes a PNG file as OpenSCAD does: of 16 bits the upper 8, without regard to opacity, gamma and profiles. Throws
/// std::runtime_error with the reason for files that are broken, for more than 2^26 pixels, and where the library is
/// built without libpng (STRATA_WITH_PNG). O(pixels).
[[nodiscard]] Picture picture_of_png(const std::string& bytes);

/// The heights of OpenSCAD's `surface` over a picture, the lowest row first: 100 for white, 0 for black, by the
/// luminance of sRGB's primaries. If inverted, 100/255 less the height: luminances have a range of 255, and OpenSCAD
/// takes them from 1.
[[nodiscard]] std::vector<std::vector<double>> heights_of(const Picture& picture, bool is_inverted);

}  // namespace strata::openscad
