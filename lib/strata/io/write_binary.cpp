#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "strata/io/binary.h"
#include "strata/io/blocks.h"
#include "strata/io/face_normal.h"
#include "strata/io/writers.h"

namespace strata::io {
namespace {

template <class Number>
void append_bytes(std::string& bytes, Number x, std::endian order) {
  char raw[sizeof(Number)];
  store(raw, x, order);
  bytes.append(raw, sizeof raw);
}

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

/// Notes how many vertices binary STL cannot hold; fails at those that no float is near.
std::vector<std::string> check_floats(MeshView mesh, const std::string& name) {
  std::size_t rounded = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vertex& p = mesh.vertices[i];
    for (const double x : p)
      if (std::abs(x) > std::numeric_limits<float>::max())
        throw IoError(name, {},
                      "vertex " + std::to_string(i) +
                          " is beyond the range of floats, and binary STL holds "
                          "floats only; stl-ascii, obj, off and ply hold doubles");
    rounded += !std::all_of(p.begin(), p.end(), is_float);
  }
  if (rounded == 0) return {};
  return {std::to_string(rounded) + " of " + std::to_string(mesh.vertices.size()) +
          " vertices were rounded: binary STL holds floats only; stl-ascii, obj, off and ply hold doubles"};
}

}  // namespace

std::vector<std::string> write_stl(MeshView mesh, Sink& sink, const std::string& name) {
  auto notes = check_floats(mesh, name);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  if (count != mesh.triangles.size()) throw IoError(name, {}, "binary STL holds fewer than 2^32 triangles");
  // The header must not start with "solid".
  std::string header = "binary STL, coordinates as given";
  header.resize(80, ' ');
  append_bytes(header, count, std::endian::little);
  sink.write(header);
  write_blocks(sink, count, [&](std::size_t i, std::string& bytes) {
    const Triangle& t = mesh.triangles[i];
    for (const float x : face_normal(mesh, t)) append_bytes(bytes, x, std::endian::little);
    for (const std::uint32_t v : t)
      for (const double x : mesh.vertices[v]) append_bytes(bytes, static_cast<float>(x), std::endian::little);
    append_bytes(bytes, std::uint16_t{0}, std::endian::little);
  });
  return notes;
}

std::string ply_header(MeshView mesh, const std::string& format) {
  std::string text = "ply\nformat " + format + " 1.0\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += std::string("property double ") + axis + "\n";
  // Many readers know signed indices only.
  const bool is_signed = mesh.vertices.size() <= std::size_t{1} << 31;
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  text += std::string("property list uchar ") + (is_signed ? "int" : "uint") + " vertex_indices\n";
  return text + "end_header\n";
}

void write_ply_binary(MeshView mesh, Sink& sink, bool big_endian) {
  const std::endian order = big_endian ? std::endian::big : std::endian::little;
  sink.write(ply_header(mesh, big_endian ? "binary_big_endian" : "binary_little_endian"));
  write_blocks(sink, mesh.vertices.size(), [&](std::size_t i, std::string& bytes) {
    for (const double x : mesh.vertices[i]) append_bytes(bytes, x, order);
  });
  write_blocks(sink, mesh.triangles.size(), [&](std::size_t i, std::string& bytes) {
    bytes += '\3';
    for (const std::uint32_t v : mesh.triangles[i]) append_bytes(bytes, v, order);
  });
}

}  // namespace strata::io
