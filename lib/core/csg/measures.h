#pragma once
#include <span>

#include "core/kernel/input_complex.h"
#include "core/mesh/connections.h"
#include "core/mesh/nearest_mesh.h"
#include "core/select/extract.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// As `measure`, in the current task arena. Throws Cancelled.
[[nodiscard]] Measures measures_of(ExactMeshView mesh, Facets facets, const Monitor& monitor);

/// The same of a result, with facets, mostly without its exact vertices: facets by the planes of the faces from which
/// triangles come, volume and area by points as sums of two doubles. Fractions are computed where these do not decide,
/// or where few vertices are rational. `mesh`: the boundary with nearest vertices; `sources` per triangle. Requires
/// that triangles share no point but vertices and edges of both.
[[nodiscard]] Measures measures_of(const InputComplex& input, const Boundary& boundary, const NearestMesh& mesh,
                                   std::span<const Source> sources, const Monitor& monitor);

}  // namespace strata
