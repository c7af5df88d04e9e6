#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/binary.h"
#include "core/io/piece_source.h"
#include "core/io/readers.h"
#include "core/io/stl.h"
#include "core/io/vertex_welder.h"
#include "core/io/welded_pieces.h"

namespace strata::io {
namespace {

[[noreturn]] void fail_not_finite(std::size_t triangle, const std::array<std::array<float, 3>, 3>& corners) {
  std::size_t k = 0;
  while (std::isfinite(corners[k][0]) && std::isfinite(corners[k][1]) && std::isfinite(corners[k][2])) ++k;
  fail_at_byte(stl_header_size + triangle * stl_record_size + 12 * (k + 1),
               "expected finite coordinates in corner " + std::to_string(k) + " of triangle " +
                   std::to_string(triangle) + " (counted from 0)");
}

/// A record is a normal, three corners (12 floats, little endian) and two unused bytes. `first` is the number of the
/// first record.
void read_records(std::string_view records, std::size_t first, VertexWelder<float>& welder,
                  std::span<Triangle> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const char* bytes = records.data() + i * stl_record_size + 12;
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

MeshFile read_pieces(PieceSource& source, std::size_t count, std::size_t size, const std::string& name) {
  const std::size_t per_piece = std::max<std::size_t>(size / stl_record_size, 1);
  std::vector<Triangle> triangles;
  resize_fresh(triangles, count);
  std::vector<WeldedPiece<float>> pieces((count + per_piece - 1) / per_piece);
  tbb::enumerable_thread_specific<VertexWelder<float>> welders;
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    const std::size_t first = i * per_piece, own = std::min(per_piece, count - first);
    const std::size_t place = stl_header_size + first * stl_record_size;
    auto& welder = welders.local();
    welder.clear();
    pieces[i].triangles = std::span(triangles).subspan(first, own);
    read_records(source.get({place, place + own * stl_record_size}), first, welder, pieces[i].triangles);
    pieces[i].points = welder.copy_points();
  });
  return join<float>(pieces, std::move(triangles), name);
}

}  // namespace

MeshFile read_stl_records(const Input& input, std::uint64_t count) {
  check_stl_count(count);
  MeshFile file = read_in_pieces(input, [&](std::size_t size) {
    PieceSource source(input.data);
    return read_pieces(source, count, size, input.name);
  });
  const std::size_t end = stl_header_size + count * stl_record_size;
  if (end < input.data.size())
    file.notes.push_back(std::to_string(input.data.size() - end) + " bytes behind the last triangle were ignored");
  return file;
}

std::optional<MeshFile> read_binary_stl(const File& file, std::size_t piece) {
  if (file.size() < stl_header_size) return {};
  PieceSource source(file);
  try {
    const auto count = load<std::uint32_t>(source.get({stl_count_offset, stl_header_size}).data(), std::endian::little);
    if (file.size() != stl_header_size + std::uint64_t{count} * stl_record_size) return {};
    check_stl_count(count);
    return read_pieces(source, count, piece, file.name());
  } catch (const Malformed&) {
    return {};
  }
}

}  // namespace strata::io
