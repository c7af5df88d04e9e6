#pragma once
#include <vector>

#include "extensions/incremental/face_tree.h"
#include "extensions/incremental/tool_groups.h"
#include "strata/options.h"
#include "strata/solid.h"

namespace strata {

/// One step: the change of an incremental solid when its faces are combined with tools, all at once. Exact. Runs in the
/// current task arena. Throws as `combine` does, and LogicError when removed and new faces do not have the same
/// boundary (an operand that does not satisfy its input class). Law: steps with tools whose boxes are apart change an
/// incremental solid independently, if no two of them remove the same face.
[[nodiscard]] FaceChange change_by(const FaceTree& solid_in_steps, Operation operation, const ToolGroup& group,
                                   const Monitor& monitor);

/// The faces of a solid.
[[nodiscard]] std::vector<WorkFace> faces_of(const Tool& tool);

}  // namespace strata
