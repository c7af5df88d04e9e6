#include "common/sibling_program.h"

#include <algorithm>
#include <cstdlib>

#include "core/system/program.h"

namespace fs = std::filesystem;

namespace {

using strata::system::is_program;

/// The file of a program in a folder.
fs::path program_file(const fs::path& folder, const std::string& name) {
  return folder / (name + strata::system::program_suffix);
}

}  // namespace

fs::path own_program() { return strata::system::own_program(); }

fs::path program_in_path(const std::string& name) {
  const char* variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "" : variable;
  for (std::size_t start = 0; start < folders.size();) {
    const std::size_t end = std::min(folders.find(strata::system::path_separator, start), folders.size());
    if (fs::path path = program_file(folders.substr(start, end - start), name); is_program(path)) return path;
    start = end + 1;
  }
  return {};
}

fs::path sibling_program(const std::string& name) {
  const fs::path folder = own_program().parent_path();
  for (const fs::path& path : {program_file(folder, name), program_file(folder.parent_path() / "libexec/strata", name)})
    if (is_program(path)) return path;
  return program_in_path(name);
}
