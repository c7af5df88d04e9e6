#include <optional>
#include <utility>

#include "core/io/readers.h"

namespace strata::io {
namespace {

MeshFile with_emptiness_noted(MeshFile file) {
  if (file.mesh.triangles.empty()) file.notes.emplace_back("the file holds no faces");
  return file;
}

std::optional<MeshFile> read_piece_by_piece(const File& file, Format format, std::size_t piece,
                                            const std::filesystem::path& folder) {
  if (file.size() <= piece) return {};
  if (format == Format::stl || format == Format::stl_ascii) return read_binary_stl(file, piece);
  if (format == Format::ply || format == Format::ply_ascii || format == Format::ply_big_endian)
    return read_binary_ply(file, piece, folder);
  return {};
}

MeshFile read_bytes(const Input& input, Format format, const std::filesystem::path* folder) {
  switch (format) {
    case Format::stl:
    case Format::stl_ascii:
      return read_stl(input);
    case Format::obj:
      return read_obj(input, folder);
    case Format::off:
      return read_off(input);
    case Format::xoff:
      return read_xoff(input);
    case Format::ply:
    case Format::ply_ascii:
    case Format::ply_big_endian:
      return read_ply(input, folder);
    case Format::threemf:
      return read_3mf(input);
    case Format::glb:
      return read_glb(input, folder);
    case Format::gltf:
      return read_gltf(input, folder);
    case Format::amf:
      return read_amf(input);
    case Format::vtk:
    case Format::vtk_ascii:
    case Format::msh:
      fail("VTK and MSH files can be written, but not be read");
    case Format::other:
      return read_other(input);
  }
  return {};
}

}  // namespace

MeshFile read(const Input& input, Format format, const std::filesystem::path* folder) {
  try {
    if (input.data.empty()) fail("the file is empty");
    return with_emptiness_noted(read_bytes(input, format, folder));
  } catch (const Malformed& malformed) {
    throw input.error(malformed);
  }
}

MeshFile read(const File& file, Format format, std::size_t piece) {
  const std::filesystem::path folder = std::filesystem::absolute(file.name()).parent_path();
  if (auto mesh = read_piece_by_piece(file, format, piece, folder)) return with_emptiness_noted(std::move(*mesh));
  // Such files may refer to others beside them, so their reader needs the path.
  if (format == Format::other && file.size() > 0)
    return with_emptiness_noted(read_other(std::filesystem::path(file.name())));
  const FileBytes bytes(file);
  return read(Input{file.name(), bytes.view(), piece}, format, &folder);
}

}  // namespace strata::io
