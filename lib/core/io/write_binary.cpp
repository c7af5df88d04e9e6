#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "core/io/binary.h"
#include "core/io/blocks.h"
#include "core/io/face_normal.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

bool is_beyond_floats(const Vertex& p) {
  return std::any_of(p.begin(), p.end(), [](double x) { return std::abs(x) > std::numeric_limits<float>::max(); });
}

bool is_rounded(const Vertex& p) {
  return std::any_of(p.begin(), p.end(), [](double x) { return static_cast<double>(static_cast<float>(x)) != x; });
}

template <class Predicate>
std::size_t count_vertices(std::span<const Vertex> vertices, const Predicate& predicate) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 14), std::size_t{0},
      [&](const auto& range, std::size_t count) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) count += predicate(vertices[i]);
        return count;
      },
      std::plus<>());
}

/// Notes how many vertices binary STL cannot represent; fails at coordinates beyond the range of floats.
std::vector<std::string> check_floats(std::span<const Vertex> vertices, const std::string& name) {
  if (count_vertices(vertices, is_beyond_floats) > 0) {
    const auto first = std::find_if(vertices.begin(), vertices.end(), is_beyond_floats);
    throw IoError(name, {},
                  "vertex " + std::to_string(first - vertices.begin()) +
                      " is beyond the range of floats, and binary STL holds floats only; "
                      "stl-ascii, obj, off and ply hold doubles");
  }
  const std::size_t rounded = count_vertices(vertices, is_rounded);
  if (rounded == 0) return {};
  return {std::to_string(rounded) + " of " + std::to_string(vertices.size()) +
          " vertices were rounded: binary STL holds floats only; stl-ascii, obj, off and ply hold doubles"};
}

}  // namespace

std::vector<std::string> write_stl(MeshView mesh, Sink& sink, const std::string& name) {
  constexpr std::size_t header_size = 84, record_size = 50;
  constexpr std::endian order = std::endian::little;
  auto notes = check_floats(mesh.vertices, name);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  if (count != mesh.triangles.size()) throw IoError(name, {}, "binary STL holds fewer than 2^32 triangles");
  // The header must not start with "solid".
  std::string header = "binary STL, coordinates as given";
  header.resize(header_size, ' ');
  store(header.data() + header_size - 4, count, order);
  sink.write(header);
  write_blocks(sink, count, record_size, [&](std::size_t i, char* at) {
    const Triangle& t = mesh.triangles[i];
    for (const float x : face_normal(mesh, t)) at = store(at, x, order);
    for (const std::uint32_t v : t)
      for (const double x : mesh.vertices[v]) at = store(at, static_cast<float>(x), order);
    return store(at, std::uint16_t{0}, order);
  });
  return notes;
}

std::string ply_header(MeshView mesh, const std::string& format) {
  std::string text = "ply\nformat " + format + " 1.0\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += std::string("property double ") + axis + "\n";
  // Many readers support signed indices only.
  const bool is_signed = mesh.vertices.size() <= std::size_t{1} << 31;
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  text += std::string("property list uchar ") + (is_signed ? "int" : "uint") + " vertex_indices\n";
  return text + "end_header\n";
}

void write_ply_binary(MeshView mesh, Sink& sink, bool big_endian) {
  const std::endian order = big_endian ? std::endian::big : std::endian::little;
  sink.write(ply_header(mesh, big_endian ? "binary_big_endian" : "binary_little_endian"));
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

}  // namespace strata::io
