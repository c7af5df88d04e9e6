#pragma once
#include <cstdint>
#include <string>

#include "core/io/face_list.h"
#include "core/io/input.h"
#include "strata/io.h"

namespace strata::io {

/// Binary STL: 80 arbitrary bytes, the number of triangles, and a record for each. All in little endian.
inline constexpr std::size_t stl_header_size = 84;
inline constexpr std::size_t stl_count_offset = 80;
inline constexpr std::size_t stl_record_size = 50;

/// Every corner may be a vertex of its own.
inline void check_stl_count(std::uint64_t triangles) {
  if (3 * triangles > most_items) fail("more than " + std::to_string(most_items / 3) + " triangles");
}

/// Requires that the data have `count` records at least.
[[nodiscard]] MeshFile read_stl_records(const Input& input, std::uint64_t count);

/// One or more of: solid NAME, facets, endsolid NAME.
[[nodiscard]] MeshFile read_stl_text(const Input& input);

/// True for data that start with "solid" and continue with words of the text format: binary headers may start with
/// "solid" too.
[[nodiscard]] bool looks_like_stl_text(const Input& input);

}  // namespace strata::io
