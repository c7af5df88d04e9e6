#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Triangles grouped into sheets: sets connected over edges that exactly two triangles share.
struct Sheets {
  std::vector<std::vector<std::uint32_t>> triangles;  ///< per sheet, by increasing number
  std::vector<bool> closed;                           ///< per sheet: its own directed edges cancel
  std::uint64_t reversed = 0;                         ///< triangles that were reversed
};

/// Reverses triangles so that the two at an edge have opposite directions there. The first triangle of each sheet is
/// unchanged. A sheet that cannot be oriented keeps edges that do not cancel. Requires that no triangle repeats a
/// vertex. O(n log d) for vertices of degree d.
Sheets orient_sheets(std::vector<Triangle>& triangles, std::size_t vertex_count, const Monitor& monitor = {});

/// The changes made by orient_outwards.
struct Shells {
  std::uint64_t reversed = 0;  ///< sheets that were reversed
  std::uint64_t cavities = 0;  ///< sheets that face inwards now
};

/// Reverses closed sheets so that they face outwards, or inwards where they lie inside an odd number of others. A sheet
/// lies inside another one when all of its vertices that are no vertices of the other do; exact. Expected O(n sqrt n)
/// for sheets inside each other's boxes, O(n log n) otherwise. `trusted`: sheets that stay as they are where they face
/// outwards, also inside others; none are if it is empty.
Shells orient_outwards(std::span<const Vertex> vertices, std::vector<Triangle>& triangles, const Sheets& sheets,
                       const std::vector<bool>& trusted = {}, const Monitor& monitor = {});

}  // namespace strata
