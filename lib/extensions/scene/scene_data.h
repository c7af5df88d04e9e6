#pragma once
#include <vector>

#include "core/kernel/carriers.h"
#include "strata/query.h"

namespace strata {

struct Scene::Data {
  std::vector<ExactMesh> solids;
  Carriers carriers;
};

/// The vertices and faces of all solids in one numbering; an operand of the carriers is a solid.
[[nodiscard]] inline const Carriers& carriers_of(const Scene& scene) { return scene.data().carriers; }

}  // namespace strata
