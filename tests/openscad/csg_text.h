#pragma once
#include <string>

#include "strata/openscad.h"

namespace strata::test {

inline Solid solid_of(const std::string& text) { return read_csg(text, "test.csg").expression.evaluate(); }

inline Rational volume_of(const std::string& text) { return solid_of(text).volume(); }

/// "line:column: reason", or nothing when the text is read.
inline std::string error_of(const std::string& text) {
  try {
    (void)read_csg(text, "test.csg");
    return {};
  } catch (const CsgError& e) {
    return std::to_string(e.line()) + ":" + std::to_string(e.column()) + ": " + e.reason();
  }
}

/// All notes, one per line.
inline std::string notes_of(const std::string& text) {
  std::string notes;
  for (const std::string& n : read_csg(text, "test.csg").notes) notes += n + "\n";
  return notes;
}

}  // namespace strata::test
