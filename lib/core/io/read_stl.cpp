#include <cstdint>
#include <string>

#include "core/io/binary.h"
#include "core/io/readers.h"
#include "core/io/stl.h"
#include "core/io/text_cursor.h"

namespace strata::io {

MeshFile read_stl(const Input& input) {
  const std::size_t size = input.data.size();
  if (size >= stl_header_size) {
    const auto count = load<std::uint32_t>(input.data.data() + stl_count_offset, std::endian::little);
    const std::uint64_t needed = stl_header_size + std::uint64_t{count} * stl_record_size;
    if (needed == size) return read_stl_records(input, count);
    if (looks_like_stl_text(input)) return read_stl_text(input);
    if (needed < size) return read_stl_records(input, count);
    fail_at_byte(stl_count_offset, "binary STL of " + std::to_string(count) + " triangles takes " +
                                       std::to_string(needed) + " bytes, but the file has " + std::to_string(size) +
                                       ": truncated, or no STL");
  }
  if (looks_like_stl_text(input)) return read_stl_text(input);
  if (TextCursor text(input.data, {}); text.next_word_anywhere())
    text.fail_expected("'solid' and facets, or binary STL");
  fail_at_byte(size, "expected binary STL: a header of 80 bytes and the number of triangles");
}

}  // namespace strata::io
