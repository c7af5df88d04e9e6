#pragma once
#include <span>
#include <vector>

#include "core/kernel/box.h"
#include "extensions/incremental/painted_solid.h"
#include "strata/solid.h"

namespace strata {

/// The box of the vertices that a solid's faces use.
[[nodiscard]] Box bounds_of(const Solid& solid);

struct Tool {
  Solid solid;
  PaintedSolidPointer painted;  ///< the same, if it has attributes
};

/// Tools that are used in one step.
struct ToolGroup {
  std::vector<Tool> tools;
  Box box;  ///< of all their vertices
};

/// Groups of neighbouring tools, each large enough for a step; empty tools are left out. The order of the tools does
/// not matter to the operations that take several. Those with attributes are numbered in their order, from
/// `first_number` on. O(n log n).
[[nodiscard]] std::vector<ToolGroup> group_tools(std::span<const Solid> tools, std::uint64_t first_number);

}  // namespace strata
