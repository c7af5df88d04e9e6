#include "core/io/obj_piece.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/io/text_cursor.h"
#include "core/system/decimal.h"

namespace strata::io {
namespace {

/// Statements without vertices and faces that are not read: display, free-form details.
bool is_skipped(std::string_view keyword) {
  constexpr std::array<std::string_view, 30> known{
      "vp",   "vw",  "s",   "mg",     "usemap", "maplib",     "bevel",     "c_interp", "d_interp", "lod",
      "call", "csh", "deg", "cstype", "bmat",   "step",       "parm",      "trim",     "hole",     "scrv",
      "sp",   "end", "con", "ctech",  "stech",  "shadow_obj", "trace_obj", "bzp",      "t",        "newmtl"};
  return std::find(known.begin(), known.end(), keyword) != known.end();
}

/// Calls `use(keyword, text)` for every statement of a piece, with the cursor after the keyword.
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

/// Reads a piece, statement by statement.
class PieceReader {
 public:
  PieceReader(const Input& input, Piece place) : input_(input), place_(place) {
    is_whole_ = place.size() == input.data.size();
    vertex_count_ = is_whole_ ? count_vertices(input, place) : most_items;
  }

  ObjPiece read() {
    constexpr std::size_t bytes_per_vertex = 64;  // of a file with as many faces, or more
    piece_.vertices.reserve(place_.size() / bytes_per_vertex);
    for_each_statement(input_, place_,
                       [&](std::string_view keyword, TextCursor& text) { read_statement(keyword, text); });
    if (!is_whole_ && piece_.uses.absolute && piece_.uses.relative) fail("absolute and relative indices in one piece");
    return std::move(piece_);
  }

 private:
  void read_statement(std::string_view keyword, TextCursor& text) {
    ObjIgnored& ignored = piece_.ignored;
    if (keyword == "v")
      read_vertex(text);
    else if (keyword == "f" || keyword == "fo")
      read_face(text);
    else if (keyword == "vt")
      read_texcoord(text);
    else if (keyword == "vn")
      read_normal(text);
    else if (keyword == "usemtl")
      read_change(ObjChange::Kind::material, text);
    else if (keyword == "g")
      read_change(ObjChange::Kind::group, text);
    else if (keyword == "o")
      read_change(ObjChange::Kind::object, text);
    else if (keyword == "mtllib")
      piece_.extras.libraries.push_back(rest_of_line(text));
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
    if (!text.at_line_end()) read_color(text);
    if (!piece_.extras.colors.empty()) piece_.extras.colors.resize(3 * piece_.vertices.size(), 1);
  }

  /// After the coordinates: a weight, or a colour. What is no number is skipped.
  void read_color(TextCursor& text) {
    std::array<double, 3> color{};
    for (double& c : color) {
      const std::string_view word = text.word();
      const auto [end, error] = system::from_chars(word.data(), word.data() + word.size(), c);
      if (word.empty() || error != std::errc{} || end != word.data() + word.size() || !std::isfinite(c)) return;
    }
    piece_.extras.colors.resize(3 * (piece_.vertices.size() - 1), 1);
    piece_.extras.colors.insert(piece_.extras.colors.end(), color.begin(), color.end());
  }

  /// A number of what is no coordinate: what is none, as nan, is no reason to refuse a file.
  static double number_or_zero(TextCursor& text) {
    const std::string_view word = text.word();
    double x = 0;
    const auto [end, error] = system::from_chars(word.data(), word.data() + word.size(), x);
    return error == std::errc{} && end == word.data() + word.size() && std::isfinite(x) ? x : 0;
  }

  /// u, and v or 0; a third one may follow.
  void read_texcoord(TextCursor& text) {
    for (int k = 0; k < 2; ++k) piece_.extras.texcoords.push_back(number_or_zero(text));
  }

  void read_normal(TextCursor& text) {
    for (int k = 0; k < 3; ++k) piece_.extras.normals.push_back(number_or_zero(text));
  }

  static std::string rest_of_line(TextCursor& text) {
    std::string name;
    while (!text.at_line_end()) name.append(name.empty() ? "" : " ").append(text.word());
    return name;
  }

  void read_change(ObjChange::Kind kind, TextCursor& text) {
    piece_.extras.changes.push_back({kind, piece_.faces.count(), rest_of_line(text)});
  }

  void read_face(TextCursor& text) {
    corners_.clear();
    own_.clear();
    has_extras_ = false;
    while (!text.at_line_end()) corners_.push_back(read_corner(text));
    if (has_extras_ || !piece_.extras.corners.empty()) keep_corners();
    piece_.faces.add(corners_);
  }

  void keep_corners() {
    ObjExtras& extras = piece_.extras;
    if (extras.corners.empty()) extras.first_face = piece_.faces.count();
    own_.resize(corners_.size());
    for (std::size_t k = 0; k < own_.size(); ++k) own_[k].vertex = corners_[k];
    extras.corners.insert(extras.corners.end(), own_.begin(), own_.end());
    extras.ends.push_back(extras.corners.size());
  }

  /// An index of a texture vertex or a normal, of which there are so many in the piece so far.
  void read_extra(TextCursor& text, const char* what, std::size_t so_far, std::int64_t& index, bool& is_relative) {
    const std::int64_t given = text.leading_integer(what);
    has_extras_ = true;
    is_relative = given < 0;
    index = given == 0 ? ObjCorner::none : given < 0 ? given + static_cast<std::int64_t>(so_far) : given - 1;
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::uint32_t read_corner(TextCursor& text) {
    const std::size_t place = text.offset();
    const std::int64_t index = text.leading_integer("a vertex index");
    const std::uint32_t vertex = index > 0 ? absolute(index, place) : relative(index, place);
    if (text.accept_char('/')) {
      ObjCorner corner;
      if (!text.at_delimiter() && !text.is_at('/'))
        read_extra(text, "an index of a texture vertex", piece_.extras.texcoords.size() / 2, corner.texcoord,
                   corner.relative_texcoord);
      if (text.accept_char('/') && !text.at_delimiter())
        read_extra(text, "an index of a normal", piece_.extras.normals.size() / 3, corner.normal,
                   corner.relative_normal);
      own_.resize(corners_.size());
      own_.push_back(corner);
    }
    if (!text.at_delimiter()) fail_at_line(place, "expected a corner such as 1, 1/2, 1//3 or 1/2/3");
    return vertex;
  }

  /// An index that counts from 1.
  std::uint32_t absolute(std::int64_t index, std::size_t place) {
    const auto vertex = static_cast<std::uint64_t>(index - 1);
    if (vertex >= vertex_count_)
      fail_at_line(place, "vertex index " + std::to_string(index) + " is out of range: the file has " +
                              std::to_string(vertex_count_) + " vertices");
    piece_.uses.absolute = true;
    piece_.uses.highest = std::max(piece_.uses.highest, vertex);
    return static_cast<std::uint32_t>(vertex);
  }

  /// An index that counts back from the last vertex so far. Wraps when it refers to a vertex before the piece.
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
  std::vector<ObjCorner> own_;  ///< of the face, with what they have beside vertices
  bool has_extras_ = false;     ///< one of them has
};

}  // namespace

void ObjIgnored::note(MeshFile& file) const {
  const auto note = [&](std::uint64_t count, const char* what) {
    if (count > 0) file.notes.push_back(std::to_string(count) + " " + what + " ignored");
  };
  note(lines, "line statements (l)");
  note(points, "point statements (p)");
  note(free_form, "free-form curves and surfaces (curv, curv2, surf)");
  note(unknown, "unknown statements");
}

ObjPiece read_obj_piece(const Input& input, Piece place) { return PieceReader(input, place).read(); }

}  // namespace strata::io
