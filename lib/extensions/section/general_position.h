#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "extensions/section/axis_plane.h"
#include "strata/mesh.h"
#include "strata/planar.h"

namespace strata {

/// The section of a solid by a plane that its edges do not cross in common points, but for those at a vertex in the
/// plane that a loop passes one after the other. Then the loops of `cut` are simple and disjoint already, and no
/// arrangement is needed; theory.md, section 3. Of all triangles those of `numbers` are looked at, which are all that
/// cross the plane.
/// nullopt where edges cross the plane in common points or in points too near to tell at once, where nesting of the
/// loops would take too many tests, and where edges have not two triangles each.
/// Requires triangles that meet in common vertices and edges only: of others that it accepts, loops may cross.
/// O(k log k) for k triangles that cross it.
[[nodiscard]] std::optional<planar::Region> section_in_general_position(std::span<const Triangle> triangles,
                                                                        std::span<const std::uint32_t> numbers,
                                                                        const AxisPlane& plane);

}  // namespace strata
