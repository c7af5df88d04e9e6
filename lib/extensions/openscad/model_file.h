#pragma once
#include <string>

#include "extensions/openscad/arguments.h"
#include "strata/openscad.h"

namespace strata::openscad {

/// The path of the file that an argument names, from the model's folder. Throws CsgError where the model has none, or
/// where the file is not beneath it, unless any path is allowed, links followed; and where there is no such file.
[[nodiscard]] std::string path_of_file(const Arguments& arguments, const CsgOptions& options);

/// The extension of a path in lower case, without its point.
[[nodiscard]] std::string extension_of(const std::string& path);

/// The bytes of a file. Throws IoError.
[[nodiscard]] std::string bytes_of(const std::string& path);

}  // namespace strata::openscad
