#include "scene_input.h"

#include "strata/query.h"

SceneInput::SceneInput(std::span<const LoadedMesh> operands, const Settings& settings) {
  std::vector<strata::Solid> solids;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    solids.push_back(make_solid(operands, k, settings));
    const std::vector<std::uint32_t>& polygons = operands[k].polygon_of_triangle;
    for (const strata::Source& source : solids.back().sources())
      file_faces_.push_back(polygons.empty() ? source.face : polygons[source.face]);
  }
  scene_ = strata::scene_of(solids);
}
