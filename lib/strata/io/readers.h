#pragma once
#include "strata/io/input.h"
#include "strata/io/mesh_file.h"

namespace strata::io {

/// One reader per format. Each throws IoError with the line or byte, never reads outside the data, and allocates in
/// proportion to the size of the data only.
[[nodiscard]] MeshFile read_stl(const Input& input);
[[nodiscard]] MeshFile read_obj(const Input& input);
[[nodiscard]] MeshFile read_off(const Input& input);
[[nodiscard]] MeshFile read_ply(const Input& input);

/// Formats that are not ours, through assimp; the extension of the name picks its reader. Coordinates come as floats.
[[nodiscard]] MeshFile read_other(const Input& input);
/// The same from a file, which may refer to others beside it (glTF).
[[nodiscard]] MeshFile read_other(const std::filesystem::path& path);
/// True when read_other knows the extension (with its dot).
[[nodiscard]] bool can_read_other(const std::string& extension);

}  // namespace strata::io
