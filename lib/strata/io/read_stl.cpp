#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "strata/io/binary.h"
#include "strata/io/face_list.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"
#include "strata/io/vertex_welder.h"

namespace strata::io {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t first_record = 84;
constexpr std::size_t record_size = 50;

/// Corners of triangles on their way through the welder, in runs that stay in the cache.
class Corners {
 public:
  explicit Corners(std::size_t triangles) : welder_(std::min<std::size_t>(triangles, most_items) / 2 + 4) {
    faces_.reserve(triangles);
  }
  void add(const Vertex& p) {
    run_[used_++] = p;
    if (used_ == run_.size()) flush();
  }
  [[nodiscard]] MeshFile finish(const std::string& name) {
    flush();
    MeshFile file;
    file.mesh.vertices = std::move(welder_.vertices());
    faces_.finish(file, name);
    return file;
  }

 private:
  void flush() {
    std::array<std::uint32_t, run> number{};
    welder_.add({run_.data(), used_}, number);
    for (std::size_t i = 0; i + 2 < used_; i += 3) faces_.add(Triangle{number[i], number[i + 1], number[i + 2]});
    used_ = 0;
  }

  static constexpr std::size_t run = 3 * 128;
  std::array<Vertex, run> run_{};
  std::size_t used_ = 0;
  VertexWelder welder_;
  FaceList faces_;
};

void check_count(const Input& input, std::uint64_t triangles) {
  if (3 * triangles > most_items) input.fail("more than " + std::to_string(most_items / 3) + " triangles");
}

/// A record is a normal, three corners (12 floats, little endian) and two bytes that mean nothing.
MeshFile read_binary(const Input& input, std::uint64_t count) {
  check_count(input, count);
  Corners corners(count);
  const char* bytes = input.data.data();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t record = first_record + i * record_size;
    for (std::size_t k = 0; k < 3; ++k) {
      Vertex p;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = load<float>(bytes + record + 12 * (k + 1) + 4 * axis, std::endian::little);
      if (!std::isfinite(p[0] + p[1] + p[2]))
        input.fail_at_byte(record + 12 * (k + 1), "expected finite coordinates in corner " + std::to_string(k) +
                                                      " of triangle " + std::to_string(i) + " (counted from 0)");
      corners.add(p);
    }
  }
  MeshFile file = corners.finish(input.name);
  const std::size_t end = first_record + count * record_size;
  if (end < input.data.size())
    file.notes.push_back(std::to_string(input.data.size() - end) + " bytes behind the last triangle were ignored");
  return file;
}

void expect(TextCursor& text, const char* word) {
  if (!text.next_word_anywhere() || !text.accept(word)) text.fail_expected(std::string("'") + word + "'");
}

/// "normal nx ny nz" is not looked at: writers put anything there, and the corners say it anyhow.
void skip_normal(TextCursor& text) {
  while (true) {
    if (!text.next_word_anywhere()) text.fail_expected("'outer loop'");
    if (text.accept("outer")) break;
    text.word();
  }
  expect(text, "loop");
}

void read_facet(TextCursor& text, Corners& corners) {
  skip_normal(text);
  for (int k = 0; k < 3; ++k) {
    expect(text, "vertex");
    const double x = text.number("a number for x"), y = text.number("a number for y"),
                 z = text.number("a number for z");
    corners.add({x, y, z});
  }
  expect(text, "endloop");
  expect(text, "endfacet");
}

/// One or more of: solid NAME, facets, endsolid NAME.
MeshFile read_ascii(const Input& input) {
  // "vertex 0 0 0" three times and the words around them: no facet takes less.
  constexpr std::size_t least_facet = 60;
  check_count(input, input.data.size() / least_facet);
  Corners corners(input.data.size() / 250);
  TextCursor text(input, {});
  while (text.next_word_anywhere()) {
    expect(text, "solid");
    text.skip_line();
    while (text.next_word_anywhere() && text.accept("facet")) read_facet(text, corners);
    if (!text.accept("endsolid")) text.fail_expected("'facet' or 'endsolid'");
    text.skip_line();
  }
  return corners.finish(input.name);
}

/// Starts with "solid" and goes on with words of the text format: binary headers may start with "solid" too.
bool looks_like_text(const Input& input) {
  TextCursor text(input, {});
  if (!text.next_word_anywhere() || !text.accept("solid")) return false;
  if (input.data.substr(0, 1024).find('\0') != std::string_view::npos) return false;
  text.skip_line();
  return !text.next_word_anywhere() || text.accept("facet") || text.accept("endsolid") || text.accept("solid");
}

}  // namespace

MeshFile read_stl(const Input& input) {
  const std::size_t size = input.data.size();
  if (size >= first_record) {
    const auto count = load<std::uint32_t>(input.data.data() + header_size, std::endian::little);
    const std::uint64_t needed = first_record + std::uint64_t{count} * record_size;
    if (needed == size) return read_binary(input, count);
    if (looks_like_text(input)) return read_ascii(input);
    if (needed < size) return read_binary(input, count);
    input.fail_at_byte(header_size, "binary STL of " + std::to_string(count) + " triangles takes " +
                                        std::to_string(needed) + " bytes, but the file has " + std::to_string(size) +
                                        ": truncated, or no STL");
  }
  if (looks_like_text(input)) return read_ascii(input);
  if (TextCursor text(input, {}); text.next_word_anywhere()) text.fail_expected("'solid' and facets, or binary STL");
  input.fail_at_byte(size, "expected binary STL: a header of 80 bytes and the number of triangles");
}

}  // namespace strata::io
