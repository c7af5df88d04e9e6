#include "common/shared_folder.h"

#include <system_error>

#include "common/sibling_program.h"

namespace fs = std::filesystem;

fs::path shared_folder(const fs::path& name) {
  std::error_code ignored;
  if (fs::is_directory(name, ignored)) return name;
  const fs::path program = own_program();
  for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    for (const fs::path& found : {folder / "share/strata" / name, folder / name})
      if (fs::is_directory(found, ignored)) return found;
  return name;
}
