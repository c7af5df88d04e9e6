#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "common/byte_source.h"

/// Whole lines of a text, and where they stand in it.
struct LineBlock {
  std::string text;              ///< ends with a line end, unless the text does not
  std::uint64_t first_line = 1;  ///< number of its first line
};

/// Reads a text in blocks of whole lines, so that its memory is bounded however long the text is.
class LineBlocks {
 public:
  /// `first_line`: the number of the line that comes next.
  explicit LineBlocks(ByteSource& source, std::uint64_t first_line = 1) : source_(source), line_(first_line) {}

  /// The next lines, in the order of the text; false at its end. Throws strata::IoError, also for a line that is longer
  /// than any table has.
  bool next(LineBlock& block);
  /// Puts lines back, to be the next block.
  void put_back(LineBlock block);

 private:
  ByteSource& source_;
  LineBlock back_;     ///< put back; empty: none
  std::string begun_;  ///< the start of a line whose end is not read yet
  std::uint64_t line_;
};

/// Calls `visit(first, last, number)` for every line of a block, without its end (LF or CR LF).
template <class Visit>
void for_each_line(const LineBlock& block, const Visit& visit) {
  const char *at = block.text.data(), *const end = at + block.text.size();
  for (std::uint64_t number = block.first_line; at != end; ++number) {
    const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    const char* const stop = found == nullptr ? end : static_cast<const char*>(found);
    visit(at, stop != at && stop[-1] == '\r' ? stop - 1 : stop, number);
    at = stop == end ? end : stop + 1;
  }
}
