#pragma once
#include <span>
#include <vector>

#include "strata/csg/options.h"
#include "strata/csg/solid.h"
#include "strata/workpiece/face_tree.h"

namespace strata {

/// One step: the faces of a workpiece combined with tools, all at once. Exact. Throws as `combine` does, and LogicError
/// when the faces that come and go do not have the same boundary (an operand that is not what was declared).
[[nodiscard]] FaceTree take_step(const FaceTree& workpiece, Operation operation, std::span<const Solid> tools,
                                 const Options& options);

/// The faces of a solid.
[[nodiscard]] std::vector<WorkFace> faces_of(const Solid& solid);

}  // namespace strata
