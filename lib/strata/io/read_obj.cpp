#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strata/io/face_list.h"
#include "strata/io/large_pages.h"
#include "strata/io/pieces.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"

namespace strata::io {
namespace {

/// Statements that hold geometry which is not read.
struct Ignored {
  std::uint64_t lines = 0, points = 0, free_form = 0, unknown = 0;
  std::size_t first_unknown = 0;  ///< offset in the text

  void add_unknown(std::size_t offset) {
    if (unknown++ == 0) first_unknown = offset;
  }
  /// Adds the statements of a later piece.
  void add(const Ignored& later) {
    if (unknown == 0) first_unknown = later.first_unknown;
    lines += later.lines;
    points += later.points;
    free_form += later.free_form;
    unknown += later.unknown;
  }
  void note(MeshFile& file) const {
    const auto note = [&](std::uint64_t count, const char* what) {
      if (count > 0) file.notes.push_back(std::to_string(count) + " " + what + " ignored");
    };
    note(lines, "line statements (l)");
    note(points, "point statements (p)");
    note(free_form, "free-form curves and surfaces (curv, curv2, surf)");
    note(unknown, "unknown statements");
  }
};

/// Statements that say nothing about vertices and faces: attributes, groups, materials, display, free-form details.
bool is_skipped(std::string_view keyword) {
  constexpr std::array<std::string_view, 36> known{
      "vt",     "vn",     "vp",     "vw",    "o",          "g",         "s",    "mg",   "usemtl",
      "mtllib", "usemap", "maplib", "bevel", "c_interp",   "d_interp",  "lod",  "call", "csh",
      "deg",    "cstype", "bmat",   "step",  "parm",       "trim",      "hole", "scrv", "sp",
      "end",    "con",    "ctech",  "stech", "shadow_obj", "trace_obj", "bzp",  "t",    "newmtl"};
  return std::find(known.begin(), known.end(), keyword) != known.end();
}

/// Calls `use(keyword, text)` for every statement of a piece, the cursor being behind the keyword.
template <class Use>
void for_each_statement(const Input& input, Piece piece, const Use& use) {
  TextCursor text(input.data, {.hash_comments = true, .continuation = true}, piece);
  while (text.next_word_anywhere()) {
    use(text.word(), text);
    text.skip_line();
  }
}

std::uint64_t count_vertices(const Input& input, Piece piece) {
  std::uint64_t count = 0;
  for_each_statement(input, piece, [&](std::string_view keyword, TextCursor&) { count += keyword == "v"; });
  return count;
}

/// Which vertices the faces of a piece use.
struct Uses {
  std::uint64_t highest = 0;  ///< among those counted from the start of the file
  std::int64_t lowest = 0;    ///< among those counted back, from the start of the piece
  bool absolute = false, relative = false;
};

/// What was read from a piece. The indices of its faces count from the start of the file, or, if they are relative,
/// from the start of the piece.
struct ObjPiece {
  std::vector<Vertex> vertices;
  FaceList faces;
  Uses uses;
  Ignored ignored;
};

/// Reads a piece. Only in a piece that is the whole file every index is checked at once: there it is known how many
/// vertices stand before a face, and how many come in all. A face may use vertices that come later.
class PieceReader {
 public:
  PieceReader(const Input& input, Piece place) : input_(input), place_(place) {
    is_whole_ = place.last - place.first == input.data.size();
    vertex_count_ = is_whole_ ? count_vertices(input, place) : most_items;
  }

  ObjPiece read() {
    constexpr std::size_t bytes_per_vertex = 64;  // of a file with as many faces, or more
    piece_.vertices.reserve((place_.last - place_.first) / bytes_per_vertex);
    for_each_statement(input_, place_,
                       [&](std::string_view keyword, TextCursor& text) { read_statement(keyword, text); });
    if (!is_whole_ && piece_.uses.absolute && piece_.uses.relative) fail("absolute and relative indices in one piece");
    return std::move(piece_);
  }

 private:
  void read_statement(std::string_view keyword, TextCursor& text) {
    Ignored& ignored = piece_.ignored;
    if (keyword == "v")
      read_vertex(text);
    else if (keyword == "f" || keyword == "fo")
      read_face(text);
    else if (keyword == "l")
      ++ignored.lines;
    else if (keyword == "p")
      ++ignored.points;
    else if (keyword == "curv" || keyword == "curv2" || keyword == "surf")
      ++ignored.free_form;
    else if (!is_skipped(keyword))
      ignored.add_unknown(text.offset() - keyword.size());
  }

  /// x y z; a weight or a colour may follow.
  void read_vertex(TextCursor& text) {
    const double x = text.number("a number for x"), y = text.number("a number for y"),
                 z = text.number("a number for z");
    piece_.vertices.push_back({x, y, z});
  }

  void read_face(TextCursor& text) {
    corners_.clear();
    while (!text.at_line_end()) corners_.push_back(read_corner(text));
    piece_.faces.add(corners_);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::uint32_t read_corner(TextCursor& text) {
    const std::size_t place = text.offset();
    const std::int64_t index = text.leading_integer("a vertex index");
    const std::uint32_t vertex = index > 0 ? absolute(index, place) : relative(index, place);
    if (text.accept_char('/')) {
      if (!text.at_delimiter() && !text.is_at('/')) text.leading_integer("an index of a texture vertex");
      if (text.accept_char('/') && !text.at_delimiter()) text.leading_integer("an index of a normal");
    }
    if (!text.at_delimiter()) fail_at_line(place, "expected a corner such as 1, 1/2, 1//3 or 1/2/3");
    return vertex;
  }

  /// Counts from 1.
  std::uint32_t absolute(std::int64_t index, std::size_t place) {
    const auto vertex = static_cast<std::uint64_t>(index - 1);
    if (vertex >= vertex_count_)
      fail_at_line(place, "vertex index " + std::to_string(index) + " is out of range: the file has " +
                              std::to_string(vertex_count_) + " vertices");
    piece_.uses.absolute = true;
    piece_.uses.highest = std::max(piece_.uses.highest, vertex);
    return static_cast<std::uint32_t>(vertex);
  }

  /// Counts back from the last vertex so far. Wraps when that leads before the piece.
  std::uint32_t relative(std::int64_t index, std::size_t place) {
    if (index == 0) fail_at_line(place, "vertex index 0: indices count from 1");
    const auto so_far = static_cast<std::int64_t>(piece_.vertices.size());
    const std::int64_t vertex = so_far + index;
    if (is_whole_ && vertex < 0)
      fail_at_line(place, "relative vertex index " + std::to_string(index) + " points before the first vertex (" +
                              std::to_string(so_far) + " vertices so far)");
    piece_.uses.relative = true;
    piece_.uses.lowest = std::min(piece_.uses.lowest, vertex);
    return static_cast<std::uint32_t>(vertex);
  }

  const Input& input_;
  Piece place_;
  bool is_whole_;
  std::uint64_t vertex_count_;  ///< of the file; in pieces, what indices have room for
  ObjPiece piece_;
  std::vector<std::uint32_t> corners_;
};

/// The number of vertices before every piece, and in all.
std::vector<std::uint64_t> vertices_before(std::span<const ObjPiece> pieces) {
  std::vector<std::uint64_t> before{0};
  for (const ObjPiece& piece : pieces) before.push_back(before.back() + piece.vertices.size());
  if (before.back() > most_items) fail("more than 2^32 - 2 vertices");
  return before;
}

/// Throws when faces use vertices that are not there.
void check(const Uses& uses, std::uint64_t before, std::uint64_t vertex_count) {
  if (uses.absolute && uses.highest >= vertex_count) fail("an index out of range");
  if (static_cast<std::int64_t>(before) + uses.lowest < 0) fail("a relative index out of range");
}

MeshFile join_pieces(const Input& input, std::vector<ObjPiece> pieces) {
  const auto before = vertices_before(pieces);
  MeshFile file;
  resize_in_large_pages(file.mesh.vertices, before.back());
  std::vector<FaceList> faces(pieces.size());
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    ObjPiece& piece = pieces[i];
    check(piece.uses, before[i], before.back());
    if (piece.uses.relative) piece.faces.shift(static_cast<std::uint32_t>(before[i]));
    std::copy(piece.vertices.begin(), piece.vertices.end(), file.mesh.vertices.begin() + before[i]);
    faces[i] = std::move(piece.faces);
  });
  gather_faces(faces, file, input.name);
  return file;
}

MeshFile read_pieces(const Input& input, std::span<const Piece> places) {
  std::vector<ObjPiece> pieces(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { pieces[i] = PieceReader(input, places[i]).read(); });
  Ignored ignored;
  bool is_empty = true;
  for (const ObjPiece& piece : pieces) {
    ignored.add(piece.ignored);
    is_empty = is_empty && piece.vertices.empty() && piece.faces.count() == 0;
  }
  if (ignored.unknown > 0 && is_empty)
    fail_at_line(ignored.first_unknown, "expected OBJ statements such as 'v 0 0 0' and 'f 1 2 3'");
  MeshFile file = join_pieces(input, std::move(pieces));
  ignored.note(file);
  return file;
}

}  // namespace

MeshFile read_obj(const Input& input) {
  return read_in_pieces(input,
                        [&](std::size_t size) { return read_pieces(input, split_at_lines(input.data, 0, size)); });
}

}  // namespace strata::io
