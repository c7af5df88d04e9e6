#include <string_view>

#include "core/io/blocks.h"
#include "core/io/face_normal.h"
#include "core/io/losses.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {

Notes write_stl_ascii(const Target& target) {
  const MeshView mesh = target.mesh;
  Sink& sink = target.sink;
  constexpr std::string_view normal = "facet normal ", loop = " outer loop\n", vertex = "  vertex ",
                             end = " endloop\nendfacet\n";
  constexpr std::size_t most = longest_line(normal) + loop.size() + 3 * longest_line(vertex) + end.size();
  sink.write("solid strata\n");
  write_blocks(sink, mesh.triangles.size(), most, [&](std::size_t i, char* at) {
    at = append_line(at, normal, face_normal(mesh, mesh.triangles[i]));
    at = append(at, loop);
    for (const std::uint32_t v : mesh.triangles[i]) at = append_line(at, vertex, mesh.vertices[v]);
    return append(at, end);
  });
  sink.write("endsolid strata\n");
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "STL");
  return notes;
}

}  // namespace strata::io
