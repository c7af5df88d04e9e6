#pragma once
#include <vector>

#include "core/kernel/input_complex.h"
#include "strata/query.h"

namespace strata {

struct Scene::Data {
  Data(std::vector<ExactMesh> listed, const Monitor& monitor);

  std::vector<ExactMesh> solids;
  InputComplex input;
};

/// The vertices and faces of all solids in one numbering; an operand of the input complex is a solid.
[[nodiscard]] inline const InputComplex& input_complex_of(const Scene& scene) { return scene.data().input; }

}  // namespace strata
