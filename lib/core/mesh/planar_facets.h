#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/planar_chain.h"
#include "core/mesh/planar_points.h"
#include "strata/measure.h"

namespace strata::facets {

/// Coefficients of a x + b y + c z = d.
using Coefficients = std::array<Integer, 4>;

/// All facets in one plane, of both orientations. The first nonzero coefficient is positive. Front facets have their
/// outward normal along (a, b, c).
struct PlaneFacets {
  Coefficients plane;
  std::vector<Side> sides;
  bool has_front = false;
  bool has_back = false;
};

/// Facets of a boundary by plane, over one table of points.
struct FacetsByPlane {
  PointTable points;
  std::vector<PlaneFacets> planes;
};

/// Planar polygons with holes over common points, in flat arrays. Loops as in ExactFacet.
struct IndexedFacets {
  std::span<const RationalPoint> points;
  std::vector<std::uint32_t> corners;      ///< of all loops, by numbers of points
  std::vector<std::uint32_t> loop_ends;    ///< in `corners`
  std::vector<std::uint32_t> facet_loops;  ///< how many loops each facet has
};

/// Groups facets by their exact plane. Facets of zero area are left out. Expected O(n log n) for sorting the points.
/// Throws Cancelled.
[[nodiscard]] FacetsByPlane facets_by_plane(const ExactMesh& mesh, const Monitor& monitor);

/// Throws std::invalid_argument when a facet is not planar.
[[nodiscard]] FacetsByPlane facets_by_plane(const IndexedFacets& facets, const Monitor& monitor);

/// The canonical form of a boundary, as that of its ExactFacets. Throws what `facets_by_plane` does.
[[nodiscard]] CanonicalForm canonical_form(const IndexedFacets& facets, const Monitor& monitor);

}  // namespace strata::facets
