#pragma once
#include <cstdint>
#include <string>

#include "core/io/text_cursor.h"

namespace strata::io {

/// Reads the number of a vertex, from 0. Throws Malformed when there is none or no such vertex.
inline std::uint32_t read_vertex_index(TextCursor& text, std::uint64_t vertex_count) {
  const std::size_t place = text.offset();
  const std::int64_t index = text.integer("a vertex index");
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count)
    fail_at_line(place, "vertex index " + std::to_string(index) + " is out of range: the file has " +
                            std::to_string(vertex_count) + " vertices, counted from 0");
  return static_cast<std::uint32_t>(index);
}

}  // namespace strata::io
