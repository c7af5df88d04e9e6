#include <utility>
#include <vector>

#include "strata/query.h"

namespace strata {

Scene scene_of(std::span<const Solid> solids, const Monitor& monitor) {
  std::vector<ExactMesh> meshes;
  meshes.reserve(solids.size());
  for (const Solid& s : solids) meshes.push_back(s.exact_mesh());
  return Scene(std::move(meshes), monitor);
}

}  // namespace strata
