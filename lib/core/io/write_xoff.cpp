#include <algorithm>
#include <string>

#include "core/io/blocks.h"
#include "core/io/losses.h"
#include "core/io/writers.h"
#include "core/io/xoff_number.h"

namespace strata::io {
namespace {

/// The first vertex from `v` on that has an exact position.
auto find_exact(std::span<const ExactVertex> exact, std::size_t v) {
  return std::lower_bound(exact.begin(), exact.end(), v,
                          [](const ExactVertex& e, std::size_t w) { return e.vertex < w; });
}

void append_line(std::string& text, const Vertex& nearest, const RationalPoint* exact) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (exact == nullptr)
      append_coordinate(text, nearest[i]);
    else
      append_coordinate(text, (*exact)[i], nearest[i]);
    text += i < 2 ? ' ' : '\n';
  }
}

}  // namespace

Notes write_xoff(const Target& target) {
  const MeshView mesh = target.mesh;
  const auto exact = target.exact;
  Sink& sink = target.sink;
  sink.write("XOFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n");
  write_texts(sink, mesh.vertices.size(), [&](std::size_t v, std::string& text) {
    const auto at = find_exact(exact, v);
    append_line(text, mesh.vertices[v], at != exact.end() && at->vertex == v ? &at->position : nullptr);
  });
  write_texts(sink, mesh.triangles.size(), [&](std::size_t f, std::string& text) {
    text += '3';
    for (const std::uint32_t v : mesh.triangles[f]) text.append(" ").append(std::to_string(v));
    text += '\n';
  });
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "XOFF");
  return notes;
}

}  // namespace strata::io
