#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/exact_polygon.h"
#include "core/io/face_list.h"
#include "core/io/line_records.h"
#include "core/io/readers.h"
#include "core/io/tally.h"
#include "core/io/text_cursor.h"
#include "core/io/vertex_index.h"
#include "core/io/xoff_number.h"

namespace strata::io {
namespace {

constexpr TextCursor::Syntax xoff_syntax{.hash_comments = true, .continuation = false};

/// Advances to the next line. Only a comment may follow on this one.
void end_line(TextCursor& text) {
  if (!text.at_line_end()) text.fail_expected("the end of the line");
  text.skip_line();
}

struct XoffHeader {
  std::uint64_t vertices = 0, faces = 0;
  std::size_t end = 0;  ///< offset of the first line after it
};

XoffHeader read_xoff_header(const Input& input) {
  TextCursor text(input.data, xoff_syntax);
  if (!text.next_word_anywhere() || !text.accept("XOFF")) text.fail_expected("'XOFF'");
  const auto next_count = [&](const char* what, std::uint64_t bytes) {
    if (!text.next_word_anywhere()) text.fail_expected(std::string("the ") + what);
    const std::size_t place = text.offset();
    const std::uint64_t count = text.count(what, bytes);
    if (count > most_items) fail_at_line(place, std::string("the ") + what + " is more than 2^32 - 2");
    return count;
  };
  // The shortest vertex is "0 0 0", the shortest face "3 0 1 2".
  XoffHeader header;
  header.vertices = next_count("number of vertices", 6);
  header.faces = next_count("number of faces", 8);
  if (!text.next_word_anywhere()) text.fail_expected("the number of edges");
  (void)text.integer("the number of edges");
  end_line(text);
  header.end = text.offset();
  return header;
}

Vertex read_vertex(TextCursor& text, std::uint64_t number, std::vector<ExactVertex>& exact) {
  if (!text.next_word_anywhere()) text.fail_expected("vertex " + std::to_string(number));
  std::array<ExactCoordinate, 3> x;
  for (ExactCoordinate& c : x) {
    if (text.at_line_end()) text.fail_expected("a coordinate of vertex " + std::to_string(number));
    c = read_coordinate(text);
  }
  end_line(text);
  if (x[0].exact || x[1].exact || x[2].exact) {
    const auto place = [](ExactCoordinate& c) { return c.exact ? std::move(*c.exact) : to_rational(c.nearest); };
    exact.push_back({static_cast<std::uint32_t>(number), {place(x[0]), place(x[1]), place(x[2])}});
  }
  return {x[0].nearest, x[1].nearest, x[2].nearest};
}

/// The triangles of a piece, each with its face, counted from the file's first.
struct FacePiece {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> faces;
  Tally dropped;
  bool plain = true;  ///< one triangle per face
};

/// Reads faces, when all vertices are known.
class FaceReader {
 public:
  FaceReader(TextCursor& text, const ExactVertices& vertices) : text_(text), vertices_(vertices) {}

  void read(std::uint64_t number, FacePiece& piece) {
    if (!text_.next_word_anywhere()) text_.fail_expected("face " + std::to_string(number));
    const std::size_t place = text_.offset();
    face_.corners.clear();
    face_.ends.clear();
    do {
      read_loop(number);
    } while (text_.accept("+"));
    end_line(text_);
    if (face_.corners.size() == 3)
      add_triangle(number, piece);
    else
      add_polygon(number, place, piece);
    piece.faces.resize(piece.triangles.size(), static_cast<std::uint32_t>(number));
  }

 private:
  void read_loop(std::uint64_t number) {
    if (text_.at_line_end()) text_.fail_expected("the number of corners of a hole in face " + std::to_string(number));
    const std::size_t place = text_.offset();
    const std::uint64_t size = text_.count("number of corners", 2);
    if (size < 3)
      fail_at_line(place, "expected at least 3 corners in each loop of face " + std::to_string(number) + ", found " +
                              std::to_string(size));
    for (std::uint64_t k = 0; k < size; ++k) {
      if (text_.at_line_end()) text_.fail_expected("a vertex index");
      face_.corners.push_back(read_vertex_index(text_, vertices_.rounded.size()));
    }
    face_.ends.push_back(face_.corners.size());
  }
  void add_triangle(std::uint64_t number, FacePiece& piece) {
    const Triangle t{face_.corners[0], face_.corners[1], face_.corners[2]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      piece.triangles.push_back(t);
    } else {
      piece.dropped.add(number);
      piece.plain = false;
    }
  }
  void add_polygon(std::uint64_t number, std::size_t place, FacePiece& piece) {
    const std::string fault = divide_face(face_, vertices_, piece.triangles);
    if (!fault.empty()) fail_at_line(place, "face " + std::to_string(number) + " (counted from 0) " + fault);
    piece.plain = false;
  }

  TextCursor& text_;
  const ExactVertices& vertices_;
  LoopFace face_;
};

/// Reads in two rounds, vertices first, so that every face finds its vertices.
class XoffReader {
 public:
  XoffReader(const Input& input, const XoffHeader& header, std::size_t size)
      : input_(input),
        vertex_count_(header.vertices),
        pieces_(divide_records(input, header.end, header.vertices + header.faces, xoff_syntax, size)) {}

  MeshFile read() {
    read_vertices();
    read_faces();
    gather();
    return std::move(file_);
  }

 private:
  void read_vertices() {
    resize_fresh(file_.mesh.vertices, vertex_count_);
    std::vector<std::vector<ExactVertex>> exact(pieces_.size());
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      RecordPiece& records = pieces_[i];
      TextCursor text(input_.data, xoff_syntax, records.piece);
      for (; records.first < std::min(records.last, vertex_count_); ++records.first)
        file_.mesh.vertices[records.first] = read_vertex(text, records.first, exact[i]);
      records.piece.first = text.offset();
    });
    for (auto& part : exact)
      file_.exact.insert(file_.exact.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  }

  void read_faces() {
    faces_.resize(pieces_.size());
    const ExactVertices vertices{file_.mesh.vertices, file_.exact};
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
      const RecordPiece& records = pieces_[i];
      TextCursor text(input_.data, xoff_syntax, records.piece);
      FaceReader reader(text, vertices);
      for (std::uint64_t r = records.first; r < records.last; ++r) reader.read(r - vertex_count_, faces_[i]);
      if (i + 1 == pieces_.size() && text.next_word_anywhere()) text.fail_expected("the end of the file");
    });
  }

  void gather() {
    std::vector<std::size_t> first{0};
    for (const FacePiece& p : faces_) first.push_back(first.back() + p.triangles.size());
    if (first.back() > most_items) fail("more than 2^32 - 2 triangles");
    const bool plain = std::all_of(faces_.begin(), faces_.end(), [](const FacePiece& p) { return p.plain; });
    resize_fresh(file_.mesh.triangles, first.back());
    if (!plain) resize_fresh(file_.polygon_of_triangle, first.back());
    tbb::parallel_for(std::size_t{0}, faces_.size(), [&](std::size_t i) {
      const FacePiece& p = faces_[i];
      std::copy(p.triangles.begin(), p.triangles.end(), file_.mesh.triangles.data() + first[i]);
      if (!plain) std::copy(p.faces.begin(), p.faces.end(), file_.polygon_of_triangle.data() + first[i]);
    });
    Tally dropped;
    for (const FacePiece& p : faces_) dropped.add(p.dropped);
    dropped.note_dropped(file_);
  }

  const Input& input_;
  std::uint64_t vertex_count_;
  std::vector<RecordPiece> pieces_;
  std::vector<FacePiece> faces_;
  MeshFile file_;
};

}  // namespace

MeshFile read_xoff(const Input& input) {
  const XoffHeader header = read_xoff_header(input);
  return read_in_pieces(input, [&](std::size_t size) { return XoffReader(input, header, size).read(); });
}

}  // namespace strata::io
