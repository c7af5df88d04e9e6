#include "common/scratch.h"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "strata-XXXXXX").string();  // mkdtemp fills the end in
  if (mkdtemp(name.data()) == nullptr)
    throw fs::filesystem_error("no folder for temporary files", name, {errno, std::generic_category()});
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}
