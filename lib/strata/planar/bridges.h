#pragma once
#include "strata/planar/region.h"

namespace strata::plane {

/// A polygon of a region as one polyloop (source document, 4.1): every hole is joined to what lies to its left by a
/// bridge, an edge that is walked there and back, inside of the polygon and between two of its vertices. Its interior
/// by parity, `fill` with FillRule::even_odd, is the polygon again. Bridges lie on no given line, so vertices that are
/// no doubles are rationals of the result. O(holes * vertices). Source: Eberly, "Triangulation by Ear Clipping" for
/// which vertices see each other.
[[nodiscard]] Loops bridged(const Region& region, std::uint32_t polygon);

/// One polygon of a region as a region of its own.
[[nodiscard]] Region polygon_of(const Region& region, std::uint32_t polygon);

}  // namespace strata::plane
