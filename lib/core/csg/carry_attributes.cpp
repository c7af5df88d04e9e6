#include "strata/carry_attributes.h"

#include <array>
#include <utility>
#include <vector>

#include "core/attributes/carry.h"
#include "core/csg/arena.h"
#include "core/kernel/grid_rounding.h"

namespace strata {

Attributes carry_attributes(std::span<const AttributedMesh> operands, ExactMeshView result,
                            std::span<const Source> sources, const Options& options, CutFaces cut_faces) {
  return arena_for(options, result.mesh.triangles.size()).execute([&] {
    return carry(operands, result, sources, {options.cut_material, cut_faces}, Monitor(options.cancel));
  });
}

/// The places are those in the exact mesh with each vertex rounded.
Attributes carry_attributes(const AttributedMesh& exact, const RoundedMesh& rounded, const CoordinateGrid& grid,
                            const Options& options) {
  const GridRounding round(grid);
  std::vector<Vertex> vertices(exact.mesh.mesh.vertices.begin(), exact.mesh.mesh.vertices.end());
  for (Vertex& v : vertices) v = round(v, 0);
  const AttributedMesh nearest{ExactMeshView({vertices, exact.mesh.mesh.triangles}, {}), exact.attributes};
  std::vector<Source> sources;
  sources.reserve(rounded.source_face.size());
  for (const std::uint32_t f : rounded.source_face) sources.push_back({0, f});
  return arena_for(options, sources.size()).execute([&] {
    CarryRules rules;
    rules.may_turn = false;
    return carry({&nearest, 1}, ExactMeshView(rounded.mesh, {}), sources, rules, Monitor(options.cancel));
  });
}

}  // namespace strata
