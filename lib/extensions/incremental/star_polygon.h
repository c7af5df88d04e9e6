#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/kernel/source_plane.h"
#include "core/overlap/point_table.h"

namespace strata {

/// Triangulates a simple polygon in a plane, counter-clockwise as seen from the plane's outer side; corners may be
/// straight. Ears are cut one after the other, the roundest first. Nullopt if the polygon is not simple. O(n^3) for n
/// corners, which are few.
[[nodiscard]] std::optional<std::vector<std::array<PointId, 3>>> triangulate_star(const InputComplex& input,
                                                                                  const PointTable& points,
                                                                                  const SourcePlane& plane,
                                                                                  std::span<const PointId> polygon);

}  // namespace strata
