#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "strata/io/face_list.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"

namespace strata::io {
namespace {

/// Statements that hold geometry which is not read.
struct Ignored {
  std::uint64_t lines = 0, points = 0, free_form = 0, unknown = 0;
  std::size_t first_unknown = 0;  ///< offset in the text
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

/// Reads vertices and faces; a face may use vertices that come later. Everything else is skipped.
class ObjReader {
 public:
  /// Fails at faces that use a vertex from `vertex_limit` on.
  ObjReader(const Input& input, std::uint64_t vertex_limit)
      : text_(input, {.hash_comments = true, .continuation = true}), vertex_limit_(vertex_limit) {}

  void read() {
    while (text_.next_word_anywhere()) {
      statement();
      text_.skip_line();
    }
  }
  [[nodiscard]] bool indices_fit() const { return highest_ < vertices_.size() || faces_.count() == 0; }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }

  [[nodiscard]] MeshFile finish(const Input& input) {
    if (ignored_.unknown > 0 && vertices_.empty() && faces_.count() == 0)
      input.fail_at_line(ignored_.first_unknown, "expected OBJ statements such as 'v 0 0 0' and 'f 1 2 3'");
    MeshFile file;
    file.mesh.vertices = std::move(vertices_);
    faces_.finish(file, input.name);
    note(file, ignored_.lines, "line statements (l)");
    note(file, ignored_.points, "point statements (p)");
    note(file, ignored_.free_form, "free-form curves and surfaces (curv, curv2, surf)");
    note(file, ignored_.unknown, "unknown statements");
    return file;
  }

 private:
  void statement() {
    const std::size_t place = text_.offset();
    const std::string_view keyword = text_.word();
    if (keyword == "v")
      vertex();
    else if (keyword == "f" || keyword == "fo")
      face();
    else if (keyword == "l")
      ++ignored_.lines;
    else if (keyword == "p")
      ++ignored_.points;
    else if (keyword == "curv" || keyword == "curv2" || keyword == "surf")
      ++ignored_.free_form;
    else if (!is_skipped(keyword) && ignored_.unknown++ == 0)
      ignored_.first_unknown = place;
  }

  /// x y z; a weight or a colour may follow.
  void vertex() {
    const double x = text_.number("a number for x"), y = text_.number("a number for y"),
                 z = text_.number("a number for z");
    vertices_.push_back({x, y, z});
  }

  void face() {
    corners_.clear();
    while (!text_.at_line_end()) corners_.push_back(corner());
    faces_.add(corners_);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  std::uint32_t corner() {
    const std::size_t place = text_.offset();
    const std::int64_t index = text_.leading_integer("a vertex index");
    const std::uint32_t vertex = resolve(index, place);
    if (text_.accept_char('/')) {
      if (!text_.at_delimiter() && !text_.is_at('/')) text_.leading_integer("an index of a texture vertex");
      if (text_.accept_char('/') && !text_.at_delimiter()) text_.leading_integer("an index of a normal");
    }
    if (!text_.at_delimiter()) text_.fail_at(place, "expected a corner such as 1, 1/2, 1//3 or 1/2/3");
    return vertex;
  }

  /// Indices count from 1; negative ones count back from the last vertex so far.
  std::uint32_t resolve(std::int64_t index, std::size_t place) {
    const auto so_far = static_cast<std::int64_t>(vertices_.size());
    if (index == 0) text_.fail_at(place, "vertex index 0: indices count from 1");
    if (index < -so_far)
      text_.fail_at(place, "relative vertex index " + std::to_string(index) + " points before the first vertex (" +
                               std::to_string(so_far) + " vertices so far)");
    const auto vertex = static_cast<std::uint64_t>(index > 0 ? index - 1 : so_far + index);
    if (vertex >= vertex_limit_)
      text_.fail_at(place, "vertex index " + std::to_string(index) + " is out of range: the file has " +
                               std::to_string(vertex_limit_) + " vertices");
    if (vertex > highest_) highest_ = vertex;
    return static_cast<std::uint32_t>(vertex);
  }

  static void note(MeshFile& file, std::uint64_t count, const char* what) {
    if (count > 0) file.notes.push_back(std::to_string(count) + " " + what + " ignored");
  }

  TextCursor text_;
  std::uint64_t vertex_limit_;
  std::uint64_t highest_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> corners_;
  FaceList faces_;
  Ignored ignored_;
};

}  // namespace

MeshFile read_obj(const Input& input) {
  ObjReader reader(input, most_items);
  reader.read();
  // Only the end of the file tells how many vertices there are: a second look finds the face that asks for more.
  if (!reader.indices_fit()) ObjReader(input, reader.vertex_count()).read();
  return reader.finish(input);
}

}  // namespace strata::io
