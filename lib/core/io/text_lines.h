#pragma once
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/exact/number_text.h"
#include "core/io/blocks.h"
#include "core/io/writers.h"

namespace strata::io {

inline char* append(char* at, std::string_view text) { return std::copy(text.begin(), text.end(), at); }

/// A start, three numbers with the shortest digits that read back the same, and a line end.
template <class Numbers>
char* append_line(char* at, std::string_view start, const Numbers& numbers) {
  at = append(at, start);
  for (const auto x : numbers) {
    at = std::to_chars(at, at + longest_number, x).ptr;
    *at++ = ' ';
  }
  at[-1] = '\n';
  return at;
}

constexpr std::size_t longest_line(std::string_view start) { return start.size() + 3 * (longest_number + 1); }

/// One line per vertex, then one per triangle, with the given starts and the first index.
inline void write_lines(MeshView mesh, Sink& sink, std::string_view vertex_start, std::string_view face_start,
                        std::uint32_t first) {
  write_blocks(sink, mesh.vertices.size(), longest_line(vertex_start),
               [&](std::size_t i, char* at) { return append_line(at, vertex_start, mesh.vertices[i]); });
  write_blocks(sink, mesh.triangles.size(), longest_line(face_start), [&](std::size_t i, char* at) {
    const Triangle& t = mesh.triangles[i];
    return append_line(at, face_start, Triangle{t[0] + first, t[1] + first, t[2] + first});
  });
}

}  // namespace strata::io
