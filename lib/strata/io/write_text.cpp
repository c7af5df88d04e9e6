#include "strata/io/blocks.h"
#include "strata/io/face_normal.h"
#include "strata/io/writers.h"

namespace strata::io {
namespace {

template <class Numbers>
void append_line(std::string& text, const char* start, const Numbers& numbers) {
  text += start;
  const char* before = "";
  for (const auto x : numbers) {
    text += before;
    append_number(text, x);
    before = " ";
  }
  text += '\n';
}

/// One line per vertex, then one per triangle, with the given starts and the first index.
void write_lines(MeshView mesh, Sink& sink, const char* vertex_start, const char* face_start, std::uint32_t first) {
  write_blocks(sink, mesh.vertices.size(),
               [&](std::size_t i, std::string& text) { append_line(text, vertex_start, mesh.vertices[i]); });
  write_blocks(sink, mesh.triangles.size(), [&](std::size_t i, std::string& text) {
    const Triangle& t = mesh.triangles[i];
    append_line(text, face_start, Triangle{t[0] + first, t[1] + first, t[2] + first});
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
  sink.write("solid strata\n");
  write_blocks(sink, mesh.triangles.size(), [&](std::size_t i, std::string& text) {
    append_line(text, "facet normal ", face_normal(mesh, mesh.triangles[i]));
    text += " outer loop\n";
    for (const std::uint32_t v : mesh.triangles[i]) append_line(text, "  vertex ", mesh.vertices[v]);
    text += " endloop\nendfacet\n";
  });
  sink.write("endsolid strata\n");
}

}  // namespace strata::io
