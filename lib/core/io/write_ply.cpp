#include <bit>
#include <string>

#include "core/io/binary.h"
#include "core/io/blocks.h"
#include "core/io/losses.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

std::string header(MeshView mesh, const std::string& format) {
  std::string text = "ply\nformat " + format + " 1.0\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += std::string("property double ") + axis + "\n";
  // Many readers support signed indices only.
  const bool is_signed = mesh.vertices.size() <= std::size_t{1} << 31;
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  text += std::string("property list uchar ") + (is_signed ? "int" : "uint") + " vertex_indices\n";
  return text + "end_header\n";
}

void write_binary(MeshView mesh, Sink& sink, std::endian order) {
  sink.write(header(mesh, order == std::endian::big ? "binary_big_endian" : "binary_little_endian"));
  write_blocks(sink, mesh.vertices.size(), sizeof(Vertex), [&](std::size_t i, char* at) {
    for (const double x : mesh.vertices[i]) at = store(at, x, order);
    return at;
  });
  write_blocks(sink, mesh.triangles.size(), 1 + sizeof(Triangle), [&](std::size_t i, char* at) {
    *at++ = '\3';
    for (const std::uint32_t v : mesh.triangles[i]) at = store(at, v, order);
    return at;
  });
}

}  // namespace

Notes write_ply(const Target& target, Format format) {
  if (format == Format::ply_ascii) {
    target.sink.write(header(target.mesh, "ascii"));
    write_lines(target.mesh, target.sink, "", "3 ", 0);
  } else {
    write_binary(target.mesh, target.sink, format == Format::ply_big_endian ? std::endian::big : std::endian::little);
  }
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "PLY");
  return notes;
}

}  // namespace strata::io
