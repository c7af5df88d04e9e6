#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "extensions/section/axis_plane.h"
#include "strata/mesh.h"
#include "strata/planar.h"

namespace strata {

/// The section of a solid by a plane in general position: no triangle that crosses the plane has a vertex in it, and no
/// two of their edges cross it in one point. Then the loops of `cut` are simple and disjoint already, and no arrangement
/// is needed; theory.md, section 3. Of all triangles those of `numbers` are looked at, which others do not cross.
/// nullopt where the plane is not in general position, where it cannot be told at once that it is, or where nesting of
/// the loops would take too many tests; and always where triangles are no solid's boundary in a way that is noticed.
/// Requires triangles that meet in common vertices and edges only.
/// O(k log k) for k triangles that cross it.
[[nodiscard]] std::optional<planar::Region> section_in_general_position(std::span<const Triangle> triangles,
                                                                        std::span<const std::uint32_t> numbers,
                                                                        const AxisPlane& plane);

}  // namespace strata
