#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/face_list.h"
#include "core/io/line_records.h"
#include "core/io/off_extras.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"
#include "core/io/vertex_index.h"

namespace strata::io {
namespace {

constexpr TextCursor::Syntax syntax{.hash_comments = true, .continuation = false};

/// The header: an optional keyword [ST][C][N][4][n]OFF, with or without white space after it. Letters may be in any
/// order.
OffLetters read_keyword(TextCursor& text) {
  if (!text.next_word_anywhere()) text.fail_expected("'OFF'");
  OffLetters letters;
  while (true) {
    if (!letters.texcoords && text.accept_text("ST"))
      letters.texcoords = true;
    else if (!letters.colors && text.accept_text("C"))
      letters.colors = true;
    else if (!letters.normals && text.accept_text("N"))
      letters.normals = true;
    else
      break;
  }
  const bool other_dimension = text.is_at('4') || text.is_at('n');
  if (other_dimension && (text.accept_text("4nOFF") || text.accept_text("4OFF") || text.accept_text("nOFF")))
    text.fail_here("OFF with coordinates other than x y z is not supported");
  if (!text.accept_text("OFF") && !text.is_at_digit()) text.fail_expected("'OFF' or the number of vertices");
  if (text.accept("BINARY")) text.fail_here("binary OFF is not supported");
  return letters;
}

std::uint32_t read_corner(TextCursor& text, std::uint64_t vertex_count) {
  if (!text.next_word_anywhere()) text.fail_expected("a vertex index");
  return read_vertex_index(text, vertex_count);
}

/// What a task reads.
struct OffPiece {
  explicit OffPiece(OffLetters letters) : extras(letters) {}
  FaceList faces;
  OffExtras extras;
};

/// Reads records. Every vertex and every face starts on a line of its own; normals and colours may follow.
class RecordReader {
 public:
  RecordReader(TextCursor& text, OffLetters letters) : text_(text), piece_(letters) {}

  /// Reads the vertices and faces of a piece; the vertices are the first records of the file.
  OffPiece read(const RecordPiece& records, std::span<Vertex> vertices) {
    for (std::uint64_t i = records.first; i < records.last; ++i)
      if (i < vertices.size())
        vertices[i] = read_vertex(i);
      else
        read_face(i - vertices.size(), vertices.size());
    return std::move(piece_);
  }

 private:
  Vertex read_vertex(std::uint64_t number) {
    Vertex p{};
    for (double& x : p) {
      if (!text_.next_word_anywhere()) text_.fail_expected("a coordinate of vertex " + std::to_string(number));
      x = text_.number("a number for a coordinate");
    }
    piece_.extras.add_vertex(number, words_behind());
    return p;
  }

  void read_face(std::uint64_t number, std::uint64_t vertex_count) {
    if (!text_.next_word_anywhere()) text_.fail_expected("face " + std::to_string(number));
    const std::size_t place = text_.offset();
    const std::uint64_t size = text_.count("number of corners", 2);
    if (size == 0) fail_at_line(place, "expected the corners of face " + std::to_string(number) + ", found none");
    corners_.clear();
    for (std::uint64_t k = 0; k < size; ++k) corners_.push_back(read_corner(text_, vertex_count));
    piece_.faces.add(corners_);
    piece_.extras.add_face(number, words_behind());
  }

  /// The rest of the line, which is passed.
  std::span<const std::string_view> words_behind() {
    words_.clear();
    while (!text_.at_line_end()) words_.push_back(text_.word());
    text_.skip_line();
    return words_;
  }

  TextCursor& text_;
  OffPiece piece_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::string_view> words_;
};

struct Header {
  OffLetters letters;
  std::uint64_t vertices = 0, faces = 0;
  std::size_t end = 0;  ///< offset of the first line after it
};

Header read_header(const Input& input) {
  TextCursor text(input.data, syntax);
  Header header;
  header.letters = read_keyword(text);
  const auto next_count = [&](const char* what, std::uint64_t bytes) {
    if (!text.next_word_anywhere()) text.fail_expected(std::string("the ") + what);
    return text.count(what, bytes);
  };
  // The shortest vertex is "0 0 0", the shortest face "0".
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
    std::vector<OffExtras> extras(pieces.size(), OffExtras(header.letters));
    std::atomic<bool> more = false;
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
      TextCursor text(input.data, syntax, pieces[i].piece);
      OffPiece piece = RecordReader(text, header.letters).read(pieces[i], file.mesh.vertices);
      faces[i] = std::move(piece.faces);
      extras[i] = std::move(piece.extras);
      if (i + 1 == pieces.size()) more = text.next_word_anywhere();
    });
    if (more) file.notes.emplace_back("text behind the last face was ignored");
    gather_faces(faces, file, input.name);
    for (std::size_t i = 1; i < extras.size(); ++i) extras[0].add(extras[i]);
    std::move(extras[0]).move_to(file, header.faces);
    return file;
  });
}

}  // namespace strata::io
