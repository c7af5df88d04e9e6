#include "extensions/incremental/tool_groups.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/cells/grid.h"
#include "core/containers/z_order.h"

namespace strata {
namespace {

/// A step has fixed costs, which more faces share; but all tools of one step are tested with each other.
constexpr std::size_t faces_of_step = 2000;

/// The position on a Morton curve.
std::uint32_t place_on_curve(const std::array<std::int32_t, 3>& g) {
  constexpr int dropped = 20;
  const auto cell = [&](std::size_t i) {
    return static_cast<std::uint32_t>(std::min(g[i], Grid::extent - 1)) >> dropped & 1023u;
  };
  return z_order(cell(0), cell(1), cell(2));
}

}  // namespace

Box bounds_of(const Solid& solid) {
  Box box;
  for (const Triangle& t : solid.mesh().triangles)
    for (const std::uint32_t v : t) box.include(solid.mesh().vertices[v]);
  return box;
}

std::vector<ToolGroup> group_tools(std::span<const Solid> tools, std::uint64_t first_number) {
  Box all;
  std::vector<Box> boxes;
  for (const Solid& tool : tools) {
    boxes.push_back(bounds_of(tool));
    all.include(boxes.back());
  }
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (boxes[i].empty()) continue;
    InputComplex::Coordinates middle{};
    for (std::size_t k = 0; k < 3; ++k) middle[k] = boxes[i].lower[k] / 2 + boxes[i].upper[k] / 2;
    order.emplace_back(place_on_curve(Grid(all.lower, all.upper).at(middle)), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<ToolGroup> groups;
  std::size_t faces = faces_of_step;
  for (const auto& [code, i] : order) {
    const std::size_t more = tools[i].mesh().triangles.size();
    if (faces + more > faces_of_step) {
      groups.emplace_back();
      faces = 0;
    }
    groups.back().tools.push_back({tools[i], painted(tools[i], first_number + i)});
    groups.back().box.include(boxes[i]);
    faces += more;
  }
  return groups;
}

}  // namespace strata
