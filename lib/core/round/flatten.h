#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "core/round/moving_mesh.h"
#include "core/round/wrong_faces.h"

namespace strata {

/// Makes one sheet of faces that lie on each other. Faces that are connected at common vertices or by wrong pairs and
/// lie within `reach` units of the plane of the largest wrong one of them are a pile. All that is left of a pile is
/// what fills its boundary, the sides that do not cancel, seen along an axis: triangles between vertices of that
/// boundary, each as often as the pile covers it, the two orientations against each other. Of a closed pile nothing is
/// left.
///
/// Piles are made of wrong faces first. Where the boundary of such a pile crosses or touches itself, as it is seen, all
/// faces of the region may be in it. Where that does not help either, the boundary of the first pile is divided where
/// it crosses itself, at new vertices of the grid, and flat triangles are added between its sides and their parts;
/// there may be twice as many triangles. With `may_divide_all`, that of the second pile is divided, too, where
/// triangles do not become more. What helps one pile does not keep the others from the next. Vertices of a boundary
/// that are seen as one become one.
///
/// The chain stays closed. What becomes of a pile is off by its thickness at most, which is at most twice `reach`
/// units, and by two units where it has a new vertex; vertices that become one move other faces that have them. Returns
/// whether anything changed. Expected O(n + k sqrt k) for k faces of piles among n of the region; for piles that are
/// divided, the square of their sides.
[[nodiscard]] bool flatten(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
                           const GridRounding& grid, double reach, bool may_divide_all);

}  // namespace strata
