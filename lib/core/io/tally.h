#pragma once
#include <cstdint>
#include <string>

#include "strata/io.h"

namespace strata::io {

/// A number of faces, or of other things, and the first of them.
struct Tally {
  std::uint64_t count = 0;
  std::uint64_t first = 0;

  void add(std::uint64_t number) {
    if (count++ == 0) first = number;
  }
  /// Adds those of a later list.
  void add(const Tally& later) {
    if (count == 0) first = later.first;
    count += later.count;
  }
  void note(MeshFile& file, const char* one, const char* many, const char* what, const char* kind = "face") const {
    if (count == 0) return;
    file.notes.push_back((count == 1 ? std::string("1 ") + one : std::to_string(count) + " " + many) + " " + what +
                         "; the first is " + kind + " " + std::to_string(first) + " (counted from 0)");
  }
  /// Adds the note that faces were left out.
  void note_dropped(MeshFile& file) const {
    note(file, "face", "faces", "with fewer than three different vertices left out");
  }
};

}  // namespace strata::io
