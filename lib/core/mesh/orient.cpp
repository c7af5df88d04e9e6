#include "core/mesh/orient.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/exact/pace.h"
#include "core/mesh/edge_table.h"

namespace strata {
namespace {

/// The triangle across each side of each triangle, where there is exactly one.
struct Neighbours {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Across {
    std::uint32_t triangle = none;
    bool same_direction = false;  ///< both have the same direction along the edge: one of them is to be reversed
  };
  std::vector<std::array<Across, 3>> of;

  Neighbours(const std::vector<EdgeUse>& table, std::size_t triangle_count, const Monitor& monitor)
      : of(triangle_count) {
    const auto connect = [&](std::span<const EdgeUse> uses) {
      if (uses.size() != 2) return;
      const bool same = uses[0].forward == uses[1].forward;
      of[uses[0].triangle][uses[0].corner] = {uses[1].triangle, same};
      of[uses[1].triangle][uses[1].corner] = {uses[0].triangle, same};
    };
    for_each_edge(table, connect, monitor);
  }
};

constexpr std::uint32_t unvisited = std::numeric_limits<std::uint32_t>::max();

/// Collects the sheet of one triangle. `reverse` records for each triangle whether it must be reversed.
std::vector<std::uint32_t> collect(std::uint32_t seed, std::uint32_t sheet, const Neighbours& neighbours,
                                   std::vector<std::uint32_t>& sheet_of, std::vector<bool>& reverse,
                                   const Monitor& monitor) {
  std::vector<std::uint32_t> members{seed};
  sheet_of[seed] = sheet;
  Pace pace(monitor);
  for (std::size_t i = 0; i < members.size(); ++i) {
    pace.step();
    const std::uint32_t t = members[i];
    for (const auto& across : neighbours.of[t]) {
      if (across.triangle == Neighbours::none || sheet_of[across.triangle] != unvisited) continue;
      sheet_of[across.triangle] = sheet;
      reverse[across.triangle] = reverse[t] != across.same_direction;
      members.push_back(across.triangle);
    }
  }
  std::sort(members.begin(), members.end());
  return members;
}

/// Marks the sheets that have an edge whose uses by this sheet do not cancel.
std::vector<bool> closed_sheets(const std::vector<EdgeUse>& table, const std::vector<std::uint32_t>& sheet_of,
                                const std::vector<bool>& reverse, std::size_t sheet_count, const Monitor& monitor) {
  std::vector<bool> closed(sheet_count, true);
  std::vector<std::pair<std::uint32_t, int>> net;  // sheet, direction
  const auto sum_up = [&](std::span<const EdgeUse> uses) {
    net.clear();
    for (const EdgeUse& use : uses)
      net.emplace_back(sheet_of[use.triangle], use.forward != reverse[use.triangle] ? 1 : -1);
    std::sort(net.begin(), net.end());
    for (std::size_t i = 0; i < net.size();) {
      const std::uint32_t sheet = net[i].first;
      int sum = 0;
      for (; i < net.size() && net[i].first == sheet; ++i) sum += net[i].second;
      if (sum != 0) closed[sheet] = false;
    }
  };
  for_each_edge(table, sum_up, monitor);
  return closed;
}

}  // namespace

Sheets orient_sheets(std::vector<Triangle>& triangles, std::size_t vertex_count, const Monitor& monitor) {
  const std::vector<EdgeUse> table = edge_table(triangles, vertex_count, monitor);
  const Neighbours neighbours(table, triangles.size(), monitor);
  std::vector<std::uint32_t> sheet_of(triangles.size(), unvisited);
  std::vector<bool> reverse(triangles.size(), false);
  Sheets sheets;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (sheet_of[t] != unvisited) continue;
    const auto sheet = static_cast<std::uint32_t>(sheets.triangles.size());
    sheets.triangles.push_back(collect(t, sheet, neighbours, sheet_of, reverse, monitor));
  }
  sheets.closed = closed_sheets(table, sheet_of, reverse, sheets.triangles.size(), monitor);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!reverse[t]) continue;
    std::swap(triangles[t][1], triangles[t][2]);
    ++sheets.reversed;
  }
  return sheets;
}

}  // namespace strata
