#pragma once
#include <string>

/// The picture as PNG, by the program rsvg-convert. Throws strata::IoError if it is not there or fails.
[[nodiscard]] std::string svg_to_png(const std::string& svg);
