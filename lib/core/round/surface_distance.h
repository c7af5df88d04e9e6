#pragma once
#include <vector>

#include "core/mesh/nearest_mesh.h"
#include "strata/monitor.h"

namespace strata {

/// Tightens upper bounds on how far triangles are from a surface, in the maximum norm: no point of triangle f of `mesh`
/// is farther from `surface` than distances[f], before and after. Bounds above `enough` are measured, others stay.
///
/// A triangle is divided along the faces of the surface that it lies on, as it is seen along an axis. The distance from
/// a face is a convex function, so none of a piece is farther from a face than the piece's farthest corner is. What
/// lies over no face is measured from the one that is nearest to all of it, and halved where that is far. All in sums
/// of two doubles with their error bounds. Where it takes too many steps, the bound stays. In parallel. O(k^2) for a
/// triangle near k faces, about.
void tighten_distances(const NearestMesh& surface, MeshView mesh, double enough, const Monitor& monitor,
                       std::vector<double>& distances);

}  // namespace strata
