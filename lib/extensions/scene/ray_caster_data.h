#pragma once
#include <utility>

#include "extensions/scene/box_tree.h"
#include "strata/query.h"

namespace strata {

struct RayCaster::Data {
  explicit Data(Scene s) : scene(std::move(s)), tree(scene) {}

  Scene scene;
  BoxTree tree;
};

/// The tree of boxes that rays traverse.
[[nodiscard]] inline const BoxTree& tree_of(const RayCaster& caster) { return caster.data().tree; }

}  // namespace strata
