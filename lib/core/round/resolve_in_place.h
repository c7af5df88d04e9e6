#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "core/round/moving_mesh.h"
#include "core/round/wrong_faces.h"
#include "strata/monitor.h"

namespace strata {

/// The mesh becomes the regular set of points with a positive winding number, for few crossings of a large mesh: only
/// faces that cross others are divided, and only patches that do not bound the set are taken out.
///
/// `crossings`: all pairs of faces that meet other than along common edges and vertices, the lower number first, in
/// increasing order. No two vertices of their faces are in one place, and all faces have an area or repeat a vertex.
/// `patches`: the faces that cross no others, but for those that are certain to bound the set.
///
/// New vertices are at the doubles nearest to them. Returns the way that each must go to the grid, if there is one, by
/// increasing vertex. None, and the mesh is as it was, where what would be put in does not fit: then these are not all
/// crossings, or patches do not bound the set, as when a caller promised a solid and gave something else. The same for
/// any number of threads. O(n) for what is small beside a search, and O(k log k) for k crossings and the faces of
/// patches. Throws Cancelled.
[[nodiscard]] std::optional<std::vector<VertexMove>> resolve_in_place(
    MovingMesh& mesh, std::span<const std::pair<std::uint32_t, std::uint32_t>> crossings, const FacePatches& patches,
    const GridRounding& grid, const Monitor& monitor);

}  // namespace strata
