#pragma once
#include <cstdint>
#include <vector>

#include "core/io/input.h"
#include "core/io/text_cursor.h"

namespace strata::io {

/// A piece of a text and the records in it: vertices, faces.
struct RecordPiece {
  Piece piece;
  std::uint64_t first = 0;  ///< record
  std::uint64_t last = 0;   ///< one beyond
};

/// Divides a text of `count` records from the offset on into pieces of about `size` bytes.
///
/// One piece assumes nothing. Several pieces assume that the first `count` lines that are not blank have one record
/// each. Records start on lines of their own. So if a reader finds in every piece as many records as expected, the
/// assumption was right: no record took two lines. The last piece with records extends to the end of the text. Throws
/// Malformed when there are several pieces and fewer lines than records.
[[nodiscard]] std::vector<RecordPiece> divide_records(const Input& input, std::size_t offset, std::uint64_t count,
                                                      TextCursor::Syntax syntax, std::size_t size);

}  // namespace strata::io
