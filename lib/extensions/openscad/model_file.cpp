#include "extensions/openscad/model_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/io/file.h"

namespace strata::openscad {

namespace fs = std::filesystem;

std::string path_of_file(const Arguments& arguments, const CsgOptions& options) {
  const std::string name = arguments.text("file", {});
  if (options.folder.empty() && !options.any_path)
    arguments.fail("file", "is not read: the model has no folder in which to look for '" + name + "'");
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(options.folder.empty() ? "." : options.folder, error);
  const fs::path path = fs::weakly_canonical(folder / name, error);
  const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first;
  if (!options.any_path && end != folder.end())
    arguments.fail("file", "is not beneath the model's folder: '" + name + "' (--allow-path reads it)");
  if (!fs::exists(path, error)) arguments.fail("file", "is missing: there is no '" + name + "'");
  return path.string();
}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension.empty() ? extension : extension.substr(1);
}

std::string bytes_of(const std::string& path) {
  const io::File file(path);
  const io::FileBytes bytes(file);
  return std::string(bytes.view());
}

}  // namespace strata::openscad
