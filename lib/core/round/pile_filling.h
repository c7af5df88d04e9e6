#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "core/round/moving_mesh.h"
#include "core/round/viewed_plane.h"

namespace strata {

/// What faces near one plane are replaced by.
struct PileFilling {
  /// Corners are numbers of vertices or, from the count of all vertices on, of added ones.
  std::vector<Triangle> triangles;
  std::vector<Vertex> added;
  std::vector<VertexMove> joined;  ///< vertices that are seen as one become one: that with the lowest number
};

/// Triangles that fill the boundary of some faces, the sides that do not cancel, as they are seen along an axis: each
/// place as often as the faces cover it, the two orientations against each other. There are fewer of them than faces.
/// Where the boundary crosses or touches itself, it is divided, at new vertices of the grid, if that takes no more
/// triangles than `most_if_divided`, and not more than 2^20 tests of points against sides. None otherwise.
/// Expected O(n sqrt n) for n sides of a boundary that is not divided, O(n p) for p points of one that is.
[[nodiscard]] std::optional<PileFilling> filling_of(MeshView mesh, std::span<const std::uint32_t> faces,
                                                    const ViewedPlane& plane, const GridRounding& grid,
                                                    std::size_t most_if_divided);

}  // namespace strata
