#pragma once
#include <string>
#include <string_view>

#include "strata/io.h"

namespace strata::test {

inline const Mesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

inline MeshFile read_text(std::string_view text, Format format, const std::string& name = "test") {
  return read_mesh(text, format, name);
}

/// What an IoError says; empty when nothing is thrown.
inline std::string refusal(std::string_view text, Format format) {
  try {
    (void)read_mesh(text, format, "test");
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

/// The line of an IoError; 0 when none is thrown or it has no line.
inline std::uint64_t refused_line(std::string_view text, Format format) {
  try {
    (void)read_mesh(text, format, "test");
  } catch (const IoError& error) {
    return error.line().value_or(0);
  }
  return 0;
}

inline std::string all_notes(const std::vector<std::string>& notes) {
  std::string text;
  for (const auto& note : notes) text.append(note).append("\n");
  return text;
}

}  // namespace strata::test
