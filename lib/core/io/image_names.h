#pragma once
#include <string>
#include <vector>

#include "strata/attributes.h"

namespace strata::io {

/// "image/png" or "image/jpeg", by the first bytes where the image does not say.
[[nodiscard]] std::string media_type_of(const Image& image);

/// Names of files for images: without folders, each different, with an extension.
[[nodiscard]] std::vector<std::string> file_names_of(const std::vector<Image>& images);

}  // namespace strata::io
