#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "strata/io/face_list.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"

namespace strata::io {
namespace {

/// The header: an optional keyword [ST][C][N][4][n]OFF, with or without white space behind it.
void read_keyword(TextCursor& text) {
  if (!text.next_word_anywhere()) text.fail_expected("'OFF'");
  for (const char* prefix : {"ST", "C", "N"}) text.accept_text(prefix);
  const bool other_dimension = text.is_at('4') || text.is_at('n');
  if (other_dimension && (text.accept_text("4nOFF") || text.accept_text("4OFF") || text.accept_text("nOFF")))
    text.fail("OFF with coordinates other than x y z is not supported");
  if (!text.accept_text("OFF") && !text.is_at_digit()) text.fail_expected("'OFF' or the number of vertices");
  if (text.accept("BINARY")) text.fail("binary OFF is not supported");
}

std::uint32_t corner(TextCursor& text, std::uint64_t vertex_count) {
  if (!text.next_word_anywhere()) text.fail_expected("a vertex index");
  const std::size_t place = text.offset();
  const std::int64_t index = text.integer("a vertex index");
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count)
    text.fail_at(place, "vertex index " + std::to_string(index) + " is out of range: the file has " +
                            std::to_string(vertex_count) + " vertices, counted from 0");
  return static_cast<std::uint32_t>(index);
}

/// Every vertex and every face starts on a line of its own; normals and colours may follow.
void read_vertices(TextCursor& text, std::uint64_t count, std::vector<Vertex>& vertices) {
  vertices.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Vertex p{};
    for (double& x : p) {
      if (!text.next_word_anywhere()) text.fail_expected("a coordinate of vertex " + std::to_string(i));
      x = text.number("a number for a coordinate");
    }
    vertices.push_back(p);
    text.skip_line();
  }
}

void read_faces(TextCursor& text, std::uint64_t count, std::uint64_t vertex_count, FaceList& faces) {
  faces.reserve(count);
  std::vector<std::uint32_t> corners;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!text.next_word_anywhere()) text.fail_expected("face " + std::to_string(i));
    const std::size_t place = text.offset();
    const std::uint64_t size = text.count("number of corners", 2);
    if (size == 0) text.fail_at(place, "expected the corners of face " + std::to_string(i) + ", found none");
    corners.clear();
    for (std::uint64_t k = 0; k < size; ++k) corners.push_back(corner(text, vertex_count));
    faces.add(corners);
    text.skip_line();
  }
}

}  // namespace

MeshFile read_off(const Input& input) {
  TextCursor text(input, {.hash_comments = true, .continuation = false});
  read_keyword(text);
  const auto next_count = [&](const char* what, std::uint64_t bytes) {
    if (!text.next_word_anywhere()) text.fail_expected(std::string("the ") + what);
    return text.count(what, bytes);
  };
  // The shortest vertex is "0 0 0", the shortest face "0".
  const std::uint64_t vertices = next_count("number of vertices", 6), faces = next_count("number of faces", 2);
  // The number of edges follows on the same line, or is left out.
  text.skip_line();
  MeshFile file;
  FaceList list;
  read_vertices(text, vertices, file.mesh.vertices);
  read_faces(text, faces, vertices, list);
  if (text.next_word_anywhere()) file.notes.push_back("text behind the last face was ignored");
  list.finish(file, input.name);
  return file;
}

}  // namespace strata::io
