#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/stl.h"
#include "core/io/text_cursor.h"
#include "core/io/vertex_welder.h"
#include "core/io/welded_pieces.h"

namespace strata::io {
namespace {

void expect(TextCursor& text, const char* word) {
  if (!text.next_word_anywhere() || !text.accept(word)) text.fail_expected(std::string("'") + word + "'");
}

/// "normal nx ny nz" is ignored: writers store arbitrary values, and the corners determine it.
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

/// One or more of: solid NAME, facets, endsolid NAME. Starts outside a solid, or between two facets. True when the text
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

/// Gathers the triangles of all pieces into one array.
std::vector<Triangle> gather(std::span<WeldedPiece<double>> pieces, std::vector<std::vector<Triangle>> parts) {
  std::vector<std::size_t> first{0};
  for (const auto& part : parts) first.push_back(first.back() + part.size());
  std::vector<Triangle> triangles;
  resize_fresh(triangles, first.back());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    pieces[i].triangles = std::span(triangles).subspan(first[i], parts[i].size());
    std::copy(parts[i].begin(), parts[i].end(), pieces[i].triangles.begin());
  });
  return triangles;
}

std::vector<Piece> split_at_facets(std::string_view data, std::size_t size) {
  return split_at_lines(data, 0, size, [&](std::size_t start) {
    TextCursor text(data, {}, {start, data.size()});
    return !text.at_line_end() && text.accept("facet");
  });
}

/// Pieces start at lines that start with "facet". That these are facets is certain once all pieces are read: then every
/// piece ends between two facets, and the next one starts there.
MeshFile read_pieces(const Input& input, std::size_t size) {
  const auto places = split_at_facets(input.data, size);
  std::vector<WeldedPiece<double>> pieces(places.size());
  std::vector<std::vector<Triangle>> triangles(places.size());
  tbb::enumerable_thread_specific<VertexWelder<double>> welders;
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    auto& welder = welders.local();
    welder.clear();
    TextCursor text(input.data, {}, places[i]);
    const bool ends_in_solid = read_solids(text, i > 0, welder, triangles[i]), is_last = i + 1 == places.size();
    if (ends_in_solid == is_last) text.fail_expected("'facet' or 'endsolid'");
    pieces[i].points = welder.copy_points();
  });
  auto all = gather(pieces, std::move(triangles));
  return join<double>(pieces, std::move(all), input.name);
}

}  // namespace

MeshFile read_stl_text(const Input& input) {
  // "vertex 0 0 0" three times and the words around them: the shortest facet.
  constexpr std::size_t least_facet = 60;
  check_stl_count(input.data.size() / least_facet);
  return read_in_pieces(input, [&](std::size_t size) { return read_pieces(input, size); });
}

bool looks_like_stl_text(const Input& input) {
  TextCursor text(input.data, {});
  if (!text.next_word_anywhere() || !text.accept("solid")) return false;
  if (input.data.substr(0, 1024).find('\0') != std::string_view::npos) return false;
  text.skip_line();
  return !text.next_word_anywhere() || text.accept("facet") || text.accept("endsolid") || text.accept("solid");
}

}  // namespace strata::io
