#include "core/io/line_records.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata::io {
namespace {

/// Counts that a compiler can vectorize.
struct Counts {
  std::uint64_t line_ends = 0;  ///< LF
  std::uint64_t unusual = 0;    ///< CR, '#', and LF followed by white space
};

Counts count_characters(const char* first, const char* last) {
  Counts counts;
  while (last - first > 1) {
    // As many as bytes can count.
    const std::ptrdiff_t block = std::min<std::ptrdiff_t>(last - first - 1, 128);
    std::uint8_t line_ends = 0, unusual = 0;
    for (std::ptrdiff_t i = 0; i < block; ++i) {
      const char c = first[i], next = first[i + 1];
      const auto is_end = static_cast<std::uint8_t>(c == '\n');
      line_ends = static_cast<std::uint8_t>(line_ends + is_end);
      unusual = static_cast<std::uint8_t>(unusual + ((is_end & (next <= ' ')) | (c == '\r') | (c == '#')));
    }
    counts.line_ends += line_ends;
    counts.unusual += unusual;
    first += block;
  }
  return counts;
}

/// Lines that are not blank.
std::uint64_t count_lines(std::string_view text, Piece piece, TextCursor::Syntax syntax) {
  if (piece.first == piece.last) return 0;
  const char* const first = text.data() + piece.first;
  const Counts counts = count_characters(first, text.data() + piece.last);
  if (counts.unusual == 0 && *first > ' ' && text[piece.last - 1] == '\n') return counts.line_ends + 1;
  std::uint64_t count = 0;
  for (TextCursor cursor(text, syntax, piece); cursor.next_word_anywhere(); cursor.skip_line()) ++count;
  return count;
}

}  // namespace

std::vector<RecordPiece> divide_records(const Input& input, std::size_t offset, std::uint64_t count,
                                        TextCursor::Syntax syntax, std::size_t size) {
  const auto pieces = split_at_lines(input.data, offset, size);
  if (pieces.size() == 1) return {{pieces[0], 0, count}};
  std::vector<std::uint64_t> lines(pieces.size());
  tbb::parallel_for(std::size_t{0}, pieces.size(),
                    [&](std::size_t i) { lines[i] = count_lines(input.data, pieces[i], syntax); });
  std::vector<RecordPiece> divided;
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < pieces.size() && (divided.empty() || first < count); ++i) {
    divided.push_back({pieces[i], first, std::min(first + lines[i], count)});
    first = divided.back().last;
  }
  if (first < count) fail("fewer lines than records");
  divided.back().piece.last = input.data.size();
  return divided;
}

}  // namespace strata::io
