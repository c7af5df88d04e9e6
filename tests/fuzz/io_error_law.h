#pragma once
#include <string_view>

#include "fuzz.h"
#include "strata/errors.h"

namespace strata::fuzz {

/// What every error about a file says.
inline void check_error(const IoError& error, std::string_view file) {
  require(error.path() == file, "errors name the file");
  require(!error.reason().empty(), "errors have a reason");
  for (const char c : error.reason())
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "errors are one line without control characters");
}

}  // namespace strata::fuzz
