#pragma once
#include <span>

#include "extensions/scene/scene.h"
#include "strata/solid.h"

namespace strata {

/// The scene of some solids, numbered as they are listed: copies of their exact meshes. O(size of the meshes).
[[nodiscard]] Scene scene_of(std::span<const Solid> solids);

}  // namespace strata
