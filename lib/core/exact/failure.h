#pragma once
#include <string>

#include "strata/errors.h"

namespace strata {

/// Throws LogicError that names the face.
[[noreturn]] inline void fail(const char* what, unsigned face) {
  throw LogicError(std::string(what) + " (face " + std::to_string(face) + ")");
}

}  // namespace strata
