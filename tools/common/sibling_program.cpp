#include "common/sibling_program.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace fs = std::filesystem;

namespace {

bool can_run(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

fs::path own_program() { return fs::read_symlink("/proc/self/exe"); }

fs::path program_in_path(const std::string& name) {
  const char* variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "" : variable;
  for (std::size_t start = 0; start < folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    if (const fs::path path = fs::path(folders.substr(start, end - start)) / name; can_run(path)) return path;
    start = end + 1;
  }
  return {};
}

fs::path sibling_program(const std::string& name) {
  const fs::path folder = own_program().parent_path();
  for (const fs::path& path : {folder / name, folder.parent_path() / "libexec/strata" / name})
    if (can_run(path)) return path;
  return program_in_path(name);
}
