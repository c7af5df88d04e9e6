#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/face_list.h"
#include "core/io/line_records.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"
#include "core/io/vertex_index.h"

namespace strata::io {
namespace {

constexpr TextCursor::Syntax syntax{.hash_comments = true, .continuation = false};

/// The header: an optional keyword [ST][C][N][4][n]OFF, with or without white space after it.
void read_keyword(TextCursor& text) {
  if (!text.next_word_anywhere()) text.fail_expected("'OFF'");
  for (const char* prefix : {"ST", "C", "N"}) text.accept_text(prefix);
  const bool other_dimension = text.is_at('4') || text.is_at('n');
  if (other_dimension && (text.accept_text("4nOFF") || text.accept_text("4OFF") || text.accept_text("nOFF")))
    text.fail_here("OFF with coordinates other than x y z is not supported");
  if (!text.accept_text("OFF") && !text.is_at_digit()) text.fail_expected("'OFF' or the number of vertices");
  if (text.accept("BINARY")) text.fail_here("binary OFF is not supported");
}

std::uint32_t read_corner(TextCursor& text, std::uint64_t vertex_count) {
  if (!text.next_word_anywhere()) text.fail_expected("a vertex index");
  return read_vertex_index(text, vertex_count);
}

/// Every vertex and every face starts on a line of its own; normals and colours may follow.
Vertex read_vertex(TextCursor& text, std::uint64_t number) {
  Vertex p{};
  for (double& x : p) {
    if (!text.next_word_anywhere()) text.fail_expected("a coordinate of vertex " + std::to_string(number));
    x = text.number("a number for a coordinate");
  }
  text.skip_line();
  return p;
}

void read_face(TextCursor& text, std::uint64_t number, std::uint64_t vertex_count,
               std::vector<std::uint32_t>& corners) {
  if (!text.next_word_anywhere()) text.fail_expected("face " + std::to_string(number));
  const std::size_t place = text.offset();
  const std::uint64_t size = text.count("number of corners", 2);
  if (size == 0) fail_at_line(place, "expected the corners of face " + std::to_string(number) + ", found none");
  corners.clear();
  for (std::uint64_t k = 0; k < size; ++k) corners.push_back(read_corner(text, vertex_count));
  text.skip_line();
}

/// Reads the vertices and faces of a piece; the vertices are the first records of the file.
FaceList read_records(TextCursor& text, const RecordPiece& records, std::span<Vertex> vertices) {
  FaceList faces;
  std::vector<std::uint32_t> corners;
  for (std::uint64_t i = records.first; i < records.last; ++i) {
    if (i < vertices.size()) {
      vertices[i] = read_vertex(text, i);
    } else {
      read_face(text, i - vertices.size(), vertices.size(), corners);
      faces.add(corners);
    }
  }
  return faces;
}

struct Header {
  std::uint64_t vertices = 0, faces = 0;
  std::size_t end = 0;  ///< offset of the first line after it
};

Header read_header(const Input& input) {
  TextCursor text(input.data, syntax);
  read_keyword(text);
  const auto next_count = [&](const char* what, std::uint64_t bytes) {
    if (!text.next_word_anywhere()) text.fail_expected(std::string("the ") + what);
    return text.count(what, bytes);
  };
  // The shortest vertex is "0 0 0", the shortest face "0".
  Header header;
  header.vertices = next_count("number of vertices", 6);
  header.faces = next_count("number of faces", 2);
  // The number of edges follows on the same line, or is absent.
  text.skip_line();
  header.end = text.offset();
  return header;
}

}  // namespace

MeshFile read_off(const Input& input) {
  const Header header = read_header(input);
  return read_in_pieces(input, [&](std::size_t size) {
    const auto pieces = divide_records(input, header.end, header.vertices + header.faces, syntax, size);
    MeshFile file;
    resize_fresh(file.mesh.vertices, header.vertices);
    std::vector<FaceList> faces(pieces.size());
    std::atomic<bool> more = false;
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
      TextCursor text(input.data, syntax, pieces[i].piece);
      faces[i] = read_records(text, pieces[i], file.mesh.vertices);
      if (i + 1 == pieces.size()) more = text.next_word_anywhere();
    });
    if (more) file.notes.emplace_back("text behind the last face was ignored");
    gather_faces(faces, file, input.name);
    return file;
  });
}

}  // namespace strata::io
