#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/io/binary.h"
#include "core/io/blocks.h"
#include "core/io/face_normal.h"
#include "core/io/losses.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

bool is_beyond_floats(const Vertex& p) {
  return std::any_of(p.begin(), p.end(), [](double x) { return std::abs(x) > std::numeric_limits<float>::max(); });
}

bool is_rounded(const Vertex& p) {
  return std::any_of(p.begin(), p.end(), [](double x) { return static_cast<double>(static_cast<float>(x)) != x; });
}

/// How many vertices floats cannot hold, hold rounded, and hold as they are.
struct FloatCounts {
  std::size_t beyond = 0, rounded = 0, kept = 0;
};

FloatCounts count_floats(std::span<const Vertex> vertices) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, vertices.size(), 1 << 14), FloatCounts{},
      [&](const auto& range, FloatCounts counts) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          ++(is_beyond_floats(vertices[i]) ? counts.beyond : is_rounded(vertices[i]) ? counts.rounded : counts.kept);
        }
        return counts;
      },
      [](const FloatCounts& a, const FloatCounts& b) {
        return FloatCounts{a.beyond + b.beyond, a.rounded + b.rounded, a.kept + b.kept};
      });
}

}  // namespace

Notes note_floats(std::span<const Vertex> vertices, const std::string& name, const char* format) {
  constexpr const char* finer = " holds floats only; stl-ascii, obj, off, ply and 3mf hold doubles";
  const FloatCounts counts = count_floats(vertices);
  if (counts.beyond > 0) {
    const auto first = std::find_if(vertices.begin(), vertices.end(), is_beyond_floats);
    throw IoError(
        name, {},
        "vertex " + std::to_string(first - vertices.begin()) + " is beyond the range of floats, and " + format + finer);
  }
  if (counts.rounded == 0) return {};
  return {std::to_string(counts.rounded) + " of " + std::to_string(vertices.size()) +
          " vertices were rounded: " + format + finer};
}

Notes write_stl(const Target& target) {
  const MeshView mesh = target.mesh;
  Sink& sink = target.sink;
  constexpr std::size_t header_size = 84, record_size = 50;
  constexpr std::endian order = std::endian::little;
  auto notes = note_floats(mesh.vertices, target.name, "binary STL");
  note_losses(notes, target.attributes, target.unit, "STL");
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  if (count != mesh.triangles.size()) throw IoError(target.name, {}, "binary STL holds fewer than 2^32 triangles");
  // The header must not start with "solid".
  std::string header = "binary STL, coordinates as given";
  header.resize(header_size, ' ');
  store(header.data() + header_size - 4, count, order);
  sink.write(header);
  write_blocks(sink, count, record_size, [&](std::size_t i, char* at) {
    const Triangle& t = mesh.triangles[i];
    for (const float x : face_normal(mesh, t)) at = store(at, x, order);
    for (const std::uint32_t v : t)
      for (const double x : mesh.vertices[v]) at = store(at, static_cast<float>(x), order);
    return store(at, std::uint16_t{0}, order);
  });
  return notes;
}

}  // namespace strata::io
