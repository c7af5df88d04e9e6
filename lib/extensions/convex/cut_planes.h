#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/bsp/mesh_planes.h"
#include "extensions/convex/wedges.h"
#include "strata/options.h"

namespace strata::convex {

/// For every reflex wedge the planes that may be chosen to resolve it: those of its two faces, and at most four through
/// it and another reflex edge that meets it in an end or is parallel and near. All contain its line. New planes are
/// added to the table of `mesh_planes`; each contains three vertices of the solid. Other wedges have none. So there are
/// at most six times as many planes as reflex edges. Throws Cancelled. O(r^2) comparisons of doubles for r reflex
/// edges, O(r) planes.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cut_planes(bsp::MeshPlanes& mesh_planes,
                                                                 std::span<const bsp::Facet<3>> facets,
                                                                 std::span<const Wedge> wedges,
                                                                 const Monitor& monitor = {});

}  // namespace strata::convex
