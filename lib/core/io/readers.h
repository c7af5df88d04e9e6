#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "core/io/file.h"
#include "core/io/input.h"
#include "strata/io.h"

namespace strata::io {

/// read_mesh, with pieces of any size. Throws IoError.
[[nodiscard]] MeshFile read(const Input& input, Format format, const std::filesystem::path* folder = nullptr);
[[nodiscard]] MeshFile read(const File& file, Format format, std::size_t piece = usual_piece);

/// One reader per format. Each throws Malformed with the offset, never reads outside the data, and allocates only in
/// proportion to the size of the data. Data are read in pieces in parallel. Results and errors are the same for pieces
/// of any size (theory.md). `pieces.h` divides texts, `welded_pieces.h` joins vertices; `read_obj.cpp` is an example.
[[nodiscard]] MeshFile read_stl(const Input& input);
[[nodiscard]] MeshFile read_off(const Input& input);
[[nodiscard]] MeshFile read_xoff(const Input& input);
[[nodiscard]] MeshFile read_3mf(const Input& input);
[[nodiscard]] MeshFile read_amf(const Input& input);
/// Buffers, libraries and images that a file names are looked for in `folder`, and beneath it; nowhere if it is null.
[[nodiscard]] MeshFile read_obj(const Input& input, const std::filesystem::path* folder);
[[nodiscard]] MeshFile read_ply(const Input& input, const std::filesystem::path* folder);
[[nodiscard]] MeshFile read_glb(const Input& input, const std::filesystem::path* folder);
[[nodiscard]] MeshFile read_gltf(const Input& input, const std::filesystem::path* folder);

/// Read large binary files piece by piece, without having them in memory. Nullopt where that is impossible: the file is
/// text, or small, or malformed.
[[nodiscard]] std::optional<MeshFile> read_binary_stl(const File& file, std::size_t piece);
[[nodiscard]] std::optional<MeshFile> read_binary_ply(const File& file, std::size_t piece,
                                                      const std::filesystem::path& folder);

/// Other formats, through assimp; the extension of the name selects its reader. Coordinates are floats.
[[nodiscard]] MeshFile read_other(const Input& input);
/// The same from a file, which may refer to others beside it (glTF).
[[nodiscard]] MeshFile read_other(const std::filesystem::path& path);
/// True when read_other knows the extension (with its dot).
[[nodiscard]] bool can_read_other(const std::string& extension);

}  // namespace strata::io
