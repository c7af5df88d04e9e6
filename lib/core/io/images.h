#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files_beside.h"
#include "strata/attributes.h"

namespace strata::io {

/// "image/png" or "image/jpeg", by the first bytes where the image does not say.
[[nodiscard]] std::string media_type_of(const Image& image);

/// Names of files for images: without folders, each different, with an extension.
[[nodiscard]] std::vector<std::string> file_names_of(const std::vector<Image>& images);

/// Writes images to files of their own, and returns the names of these.
std::vector<std::string> write_beside(const std::vector<Image>& images, FilesBeside& beside);

/// The image in a file, whose type its extension says. Throws IoError.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// What is said where a model names an image that file_beneath does not find.
[[nodiscard]] std::string note_of_missing_image(const std::string& name);

}  // namespace strata::io
