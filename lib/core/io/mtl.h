#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "strata/attributes.h"

namespace strata::io {

/// Appends the materials of a library (MTL), whose images are looked for beside it; `library` is its path beneath the
/// folder. What is malformed in it is left out. Returns notes.
[[nodiscard]] std::vector<std::string> read_mtl(std::string_view text, const std::filesystem::path& folder,
                                                const std::filesystem::path& library, Attributes& attributes);

/// A library of all materials, whose images have these names of files.
[[nodiscard]] std::string mtl_text(const Attributes& attributes, const std::vector<std::string>& image_names);

/// What usemtl calls a material: its name, or its number if it has none.
[[nodiscard]] std::string mtl_name(const Attributes& attributes, std::size_t material);

}  // namespace strata::io
