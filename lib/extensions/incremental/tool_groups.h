#pragma once
#include <span>
#include <vector>

#include "core/kernel/box.h"
#include "strata/solid.h"

namespace strata {

/// The box of the vertices that a solid's faces use.
[[nodiscard]] Box bounds_of(const Solid& solid);

/// Tools that are used in one step.
struct ToolGroup {
  std::vector<Solid> tools;
  Box box;  ///< of all their vertices
};

/// Groups of neighbouring tools, each large enough for a step; empty tools are left out. The order of the tools does
/// not matter to the operations that take several. O(n log n).
[[nodiscard]] std::vector<ToolGroup> group_tools(std::span<const Solid> tools);

}  // namespace strata
