#pragma once
#include "core/containers/box_tree.h"
#include "strata/query.h"

namespace strata {

/// A tree over the faces of a scene. Boxes hold their faces wherever these are rational: one step of doubles outwards
/// around the nearest ones. Nothing is decided here. O(n log n), in parallel.
[[nodiscard]] BoxTree tree_of_faces(const Scene& scene);

}  // namespace strata
