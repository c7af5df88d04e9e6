#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/io/blocks.h"
#include "core/io/face_normal.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

/// The longest number: "-2.2250738585072014e-308" has 24 characters.
constexpr std::size_t longest_number = 24;

char* append(char* at, std::string_view text) { return std::copy(text.begin(), text.end(), at); }

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
void write_lines(MeshView mesh, Sink& sink, std::string_view vertex_start, std::string_view face_start,
                 std::uint32_t first) {
  write_blocks(sink, mesh.vertices.size(), longest_line(vertex_start),
               [&](std::size_t i, char* at) { return append_line(at, vertex_start, mesh.vertices[i]); });
  write_blocks(sink, mesh.triangles.size(), longest_line(face_start), [&](std::size_t i, char* at) {
    const Triangle& t = mesh.triangles[i];
    return append_line(at, face_start, Triangle{t[0] + first, t[1] + first, t[2] + first});
  });
}

std::string count_of(std::size_t n) { return std::to_string(n); }

}  // namespace

void write_obj(MeshView mesh, Sink& sink) {
  sink.write("# " + count_of(mesh.vertices.size()) + " vertices, " + count_of(mesh.triangles.size()) + " triangles\n");
  write_lines(mesh, sink, "v ", "f ", 1);
}

void write_off(MeshView mesh, Sink& sink) {
  sink.write("OFF\n" + count_of(mesh.vertices.size()) + " " + count_of(mesh.triangles.size()) + " 0\n");
  write_lines(mesh, sink, "", "3 ", 0);
}

void write_ply_ascii(MeshView mesh, Sink& sink) {
  sink.write(ply_header(mesh, "ascii"));
  write_lines(mesh, sink, "", "3 ", 0);
}

void write_stl_ascii(MeshView mesh, Sink& sink) {
  constexpr std::string_view normal = "facet normal ", loop = " outer loop\n", vertex = "  vertex ",
                             end = " endloop\nendfacet\n";
  constexpr std::size_t most = longest_line(normal) + loop.size() + 3 * longest_line(vertex) + end.size();
  sink.write("solid strata\n");
  write_blocks(sink, mesh.triangles.size(), most, [&](std::size_t i, char* at) {
    at = append_line(at, normal, face_normal(mesh, mesh.triangles[i]));
    at = append(at, loop);
    for (const std::uint32_t v : mesh.triangles[i]) at = append_line(at, vertex, mesh.vertices[v]);
    return append(at, end);
  });
  sink.write("endsolid strata\n");
}

}  // namespace strata::io
