#pragma once
#include <array>
#include <vector>

#include "extensions/contact/shared_pieces.h"

namespace strata::contact {

using RationalSegment = std::array<RationalPoint, 2>;

/// Maximal segments of the segments that faces share, without the closures of the polygons; ends in lexicographic
/// order. Throws Cancelled.
[[nodiscard]] std::vector<RationalSegment> contact_edges(const SharedPieces& pieces, const Monitor& monitor);

/// Positions of the points that are on no polygon and no segment of a list. Throws Cancelled.
[[nodiscard]] std::vector<RationalPoint> isolated_points(const SharedPieces& pieces,
                                                         const std::vector<RationalSegment>& edges,
                                                         const Monitor& monitor);

}  // namespace strata::contact
