#pragma once
#include <cstddef>
#include <cstdint>

#include "strata/io.h"

namespace strata::io {

/// The number of a triangle's face in the file.
[[nodiscard]] inline std::uint64_t face_of(const MeshFile& file, std::size_t triangle) {
  return file.polygon_of_triangle.empty() ? triangle : file.polygon_of_triangle[triangle];
}

/// Gives the triangles of a file the values of their faces, which the channel has.
void repeat_on_triangles(Channel& of_faces, const MeshFile& file);

}  // namespace strata::io
