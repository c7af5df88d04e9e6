#pragma once
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "core/io/input.h"

namespace strata::io {

/// A part of a file: bytes from `first` up to `last`.
struct Piece {
  std::size_t first = 0;
  std::size_t last = 0;

  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// The first start of a line after the offset, or the end of the text. A line end after a backslash, which may join two
/// lines, does not count.
[[nodiscard]] std::size_t next_line(std::string_view text, std::size_t offset);

/// Divides a text from the offset on into pieces of about `size` bytes, at least one. All but the first start at a
/// next_line for which `is_start` is true. O(number of pieces) for short lines.
template <class IsStart>
[[nodiscard]] std::vector<Piece> split_at_lines(std::string_view text, std::size_t first, std::size_t size,
                                                const IsStart& is_start) {
  std::vector<Piece> pieces{{first, text.size()}};
  while (pieces.back().size() > size) {
    std::size_t start = next_line(text, pieces.back().first + size);
    while (start < text.size() && !is_start(start)) start = next_line(text, start);
    if (start == text.size()) break;
    pieces.back().last = start;
    pieces.push_back({start, text.size()});
  }
  return pieces;
}

[[nodiscard]] inline std::vector<Piece> split_at_lines(std::string_view text, std::size_t first, std::size_t size) {
  return split_at_lines(text, first, size, [](std::size_t) { return true; });
}

/// Calls `read(size)`, which reads the input in pieces of that size in parallel. This rests on assumptions about the
/// layout, and pieces fail in no particular order. So when it throws Malformed, the input is read again as one piece,
/// which assumes nothing and finds the first error first.
template <class Read>
[[nodiscard]] auto read_in_pieces(const Input& input, const Read& read) {
  if (input.data.size() > input.piece) {
    try {
      return read(input.piece);
    } catch (const Malformed&) {
    }
  }
  return read(std::numeric_limits<std::size_t>::max());
}

}  // namespace strata::io
