#pragma once
#include <vector>

#include "extensions/incremental/face_tree.h"
#include "extensions/incremental/tool_groups.h"
#include "strata/options.h"

namespace strata {

/// An incremental solid after a step with each group of tools. Groups that are apart from each other take their steps
/// at the same time, in rounds. The rounds do not depend on the number of threads. Throws as `combine` does.
[[nodiscard]] FaceTree take_steps(FaceTree solid_in_steps, Operation operation, std::vector<ToolGroup> groups,
                                  const Options& options);

}  // namespace strata
