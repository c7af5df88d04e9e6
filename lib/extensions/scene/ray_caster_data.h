#pragma once
#include <utility>

#include "extensions/scene/face_tree.h"
#include "strata/query.h"

namespace strata {

struct RayCaster::Data {
  explicit Data(Scene s) : scene(std::move(s)), tree(tree_of_faces(scene)) {}

  Scene scene;
  BoxTree tree;
};

/// The tree of boxes that rays traverse.
[[nodiscard]] inline const BoxTree& tree_of(const RayCaster& caster) { return caster.data().tree; }

}  // namespace strata
