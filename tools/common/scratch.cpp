#include "common/scratch.h"

#include <system_error>

#include "core/system/streams.h"

Scratch::Scratch() : path_(strata::system::make_scratch_folder()) {}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}
