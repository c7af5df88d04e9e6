#pragma once
#include <vector>

#include "strata/csg/options.h"
#include "strata/select/operation.h"
#include "strata/workpiece/face_tree.h"
#include "strata/workpiece/tool_groups.h"

namespace strata {

/// A workpiece after a step with each group of tools. Groups that are apart from each other take their steps at the
/// same time, in rounds; which ones these are does not depend on the number of threads. Throws as `combine` does.
[[nodiscard]] FaceTree take_steps(FaceTree workpiece, Operation operation, std::vector<ToolGroup> groups,
                                  const Options& options);

}  // namespace strata
