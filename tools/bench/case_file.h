#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "strata/mesh.h"

namespace bench {

/// A list of meshes in one file (.bm), for programs on one machine: an int64 with their number; then per mesh int64
/// numbers of vertices and of triangles, the coordinates as doubles, the indices as int32, all in the machine's order.
/// Throws std::runtime_error: missing, truncated, or more vertices than int32 can name.
[[nodiscard]] std::vector<strata::Mesh> read_case(const std::filesystem::path& path);

/// Throws std::runtime_error when the file cannot be written whole.
void write_case(const std::filesystem::path& path, std::span<const strata::Mesh> meshes);

}  // namespace bench
