#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "strata/io/binary.h"
#include "strata/io/face_list.h"
#include "strata/io/large_pages.h"
#include "strata/io/piece_source.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"
#include "strata/io/vertex_welder.h"
#include "strata/io/welded_pieces.h"

namespace strata::io {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t first_record = 84;
constexpr std::size_t record_size = 50;

void check_count(std::uint64_t triangles) {
  if (3 * triangles > most_items) fail("more than " + std::to_string(most_items / 3) + " triangles");
}

/// Triangles in the order of the file; those whose corners are not three different vertices are left out and noted.
MeshFile finish(std::vector<Vertex> vertices, std::vector<Triangle> triangles, const std::string& name) {
  MeshFile file;
  file.mesh = {std::move(vertices), std::move(triangles)};
  const auto is_flat = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  if (std::any_of(file.mesh.triangles.begin(), file.mesh.triangles.end(), is_flat)) {
    FaceList faces;
    for (const Triangle& t : std::exchange(file.mesh.triangles, {})) faces.add(t);
    gather_faces({&faces, 1}, file, name);
  }
  return file;
}

[[noreturn]] void fail_not_finite(std::size_t triangle, const std::array<std::array<float, 3>, 3>& corners) {
  std::size_t k = 0;
  while (std::isfinite(corners[k][0]) && std::isfinite(corners[k][1]) && std::isfinite(corners[k][2])) ++k;
  fail_at_byte(first_record + triangle * record_size + 12 * (k + 1),
               "expected finite coordinates in corner " + std::to_string(k) + " of triangle " +
                   std::to_string(triangle) + " (counted from 0)");
}

/// A record is a normal, three corners (12 floats, little endian) and two bytes that mean nothing.
/// `first` is the number of the first one.
void read_records(std::string_view records, std::size_t first, VertexWelder<float>& welder,
                  std::span<Triangle> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const char* bytes = records.data() + i * record_size + 12;
    std::array<std::array<float, 3>, 3> corners;
    float differences = 0;  // NaN when a coordinate is not finite
    for (auto& p : corners)
      for (float& x : p) {
        x = load<float>(bytes, std::endian::little);
        bytes += 4;
        differences += x - x;
      }
    if (std::isnan(differences)) fail_not_finite(first + i, corners);
    for (std::size_t k = 0; k < 3; ++k) triangles[i][k] = welder.add(corners[k]);
  }
}

template <class Scalar>
std::vector<std::array<Scalar, 3>> copy_points(const VertexWelder<Scalar>& welder) {
  return {welder.points().begin(), welder.points().end()};
}

MeshFile read_binary_pieces(PieceSource& source, std::size_t count, std::size_t size, const std::string& name) {
  const std::size_t per_piece = std::max<std::size_t>(size / record_size, 1);
  std::vector<Triangle> triangles;
  resize_in_large_pages(triangles, count);
  std::vector<WeldedPiece<float>> pieces((count + per_piece - 1) / per_piece);
  tbb::enumerable_thread_specific<VertexWelder<float>> welders;
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    const std::size_t first = i * per_piece, own = std::min(per_piece, count - first);
    const std::size_t place = first_record + first * record_size;
    auto& welder = welders.local();
    welder.clear();
    pieces[i].triangles = std::span(triangles).subspan(first, own);
    read_records(source.get({place, place + own * record_size}), first, welder, pieces[i].triangles);
    pieces[i].points = copy_points(welder);
  });
  auto vertices = join<float>(pieces);
  return finish(std::move(vertices), std::move(triangles), name);
}

MeshFile read_binary(const Input& input, std::uint64_t count) {
  check_count(count);
  MeshFile file = read_in_pieces(input, [&](std::size_t size) {
    PieceSource source(input.data);
    return read_binary_pieces(source, count, size, input.name);
  });
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

Triangle read_facet(TextCursor& text, VertexWelder<double>& welder) {
  Triangle t{};
  skip_normal(text);
  for (std::uint32_t& v : t) {
    expect(text, "vertex");
    const double x = text.number("a number for x"), y = text.number("a number for y"),
                 z = text.number("a number for z");
    v = welder.add({x, y, z});
  }
  expect(text, "endloop");
  expect(text, "endfacet");
  return t;
}

/// One or more of: solid NAME, facets, endsolid NAME. Begins outside a solid, or between two facets. True when the text
/// ends between two facets.
bool read_solids(TextCursor& text, bool in_solid, VertexWelder<double>& welder, std::vector<Triangle>& triangles) {
  while (text.next_word_anywhere()) {
    if (!in_solid) {
      expect(text, "solid");
      text.skip_line();
    }
    while (text.next_word_anywhere() && text.accept("facet")) triangles.push_back(read_facet(text, welder));
    if (text.at_end()) return true;
    if (!text.accept("endsolid")) text.fail_expected("'facet' or 'endsolid'");
    text.skip_line();
    in_solid = false;
  }
  return false;
}

/// Joins pieces whose triangles are still apart.
MeshFile join_texts(std::vector<WeldedPiece<double>> pieces, std::vector<std::vector<Triangle>> parts,
                    const std::string& name) {
  std::vector<std::size_t> first{0};
  for (const auto& part : parts) first.push_back(first.back() + part.size());
  std::vector<Triangle> triangles;
  resize_in_large_pages(triangles, first.back());
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    pieces[i].triangles = std::span(triangles).subspan(first[i], parts[i].size());
    std::copy(parts[i].begin(), parts[i].end(), pieces[i].triangles.begin());
    parts[i] = {};
  });
  auto vertices = join<double>(pieces);
  return finish(std::move(vertices), std::move(triangles), name);
}

/// Pieces start at lines that start with "facet". They start between facets if every piece before ends between facets,
/// which is so when all of them can be read.
MeshFile read_ascii_pieces(const Input& input, std::size_t size) {
  const auto places = split_at_lines(input.data, 0, size, [&](std::size_t start) {
    TextCursor text(input.data, {}, {start, input.data.size()});
    return !text.at_line_end() && text.accept("facet");
  });
  std::vector<WeldedPiece<double>> pieces(places.size());
  std::vector<std::vector<Triangle>> triangles(places.size());
  tbb::enumerable_thread_specific<VertexWelder<double>> welders;
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    auto& welder = welders.local();
    welder.clear();
    TextCursor text(input.data, {}, places[i]);
    const bool ends_in_solid = read_solids(text, i > 0, welder, triangles[i]), is_last = i + 1 == places.size();
    if (ends_in_solid == is_last) text.fail_expected("'facet' or 'endsolid'");
    pieces[i].points = copy_points(welder);
  });
  return join_texts(std::move(pieces), std::move(triangles), input.name);
}

MeshFile read_ascii(const Input& input) {
  // "vertex 0 0 0" three times and the words around them: no facet takes less.
  constexpr std::size_t least_facet = 60;
  check_count(input.data.size() / least_facet);
  return read_in_pieces(input, [&](std::size_t size) { return read_ascii_pieces(input, size); });
}

/// Starts with "solid" and goes on with words of the text format: binary headers may start with "solid" too.
bool looks_like_text(const Input& input) {
  TextCursor text(input.data, {});
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
    fail_at_byte(header_size, "binary STL of " + std::to_string(count) + " triangles takes " + std::to_string(needed) +
                                  " bytes, but the file has " + std::to_string(size) + ": truncated, or no STL");
  }
  if (looks_like_text(input)) return read_ascii(input);
  if (TextCursor text(input.data, {}); text.next_word_anywhere())
    text.fail_expected("'solid' and facets, or binary STL");
  fail_at_byte(size, "expected binary STL: a header of 80 bytes and the number of triangles");
}

std::optional<MeshFile> read_binary_stl(const File& file, std::size_t piece) {
  if (file.size() < first_record) return {};
  PieceSource source(file);
  try {
    const auto count = load<std::uint32_t>(source.get({header_size, first_record}).data(), std::endian::little);
    if (file.size() != first_record + std::uint64_t{count} * record_size) return {};
    check_count(count);
    return read_binary_pieces(source, count, piece, file.name());
  } catch (const Malformed&) {
    return {};
  }
}

}  // namespace strata::io
