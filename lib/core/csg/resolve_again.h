#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/grid_rounding.h"
#include "core/round/moving_mesh.h"
#include "core/round/wrong_faces.h"
#include "strata/monitor.h"

namespace strata {

/// The mesh becomes the regular set of points with a positive winding number, its new vertices rounded. Returns false
/// if there are none: then it is a solid on the grid. In place, where few faces cross.
///
/// `region`: what was searched last, of which `wrong` are the wrong faces; nothing has changed since. `bits_less`: new
/// vertices are rounded to so many bits less, and then the others of their triangles, too, so that all that is in the
/// way becomes coarser; without any bits, all vertices are. The same for any number of threads. Throws Cancelled.
[[nodiscard]] bool resolve_again(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
                                 const GridRounding& grid, int bits_less, const Monitor& monitor);

}  // namespace strata
