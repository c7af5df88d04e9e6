#pragma once
#include <vector>

#include "extensions/incremental/face_tree.h"
#include "extensions/incremental/tool_groups.h"
#include "strata/options.h"
#include "strata/solid.h"

namespace strata {

/// One step: what it changes when the faces of a incremental solid are combined with tools, all at once. Exact. Runs in
/// the current task arena. Throws as `combine` does, and LogicError when the faces that come and go do not have the
/// same boundary (an operand that is not what was declared). Law: steps with tools whose boxes are apart change a
/// incremental solid independently, if no face is removed by two of them.
[[nodiscard]] FaceChange change_by(const FaceTree& solid_in_steps, Operation operation, const ToolGroup& group,
                                   const Monitor& monitor);

/// The faces of a solid.
[[nodiscard]] std::vector<WorkFace> faces_of(const Solid& solid);

}  // namespace strata
