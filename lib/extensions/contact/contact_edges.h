#pragma once
#include <array>
#include <vector>

#include "extensions/contact/shared_pieces.h"

namespace strata::contact {

using RationalSegment = std::array<RationalPoint, 2>;

/// Maximal segments of the segments that faces share, without the closures of the polygons; ends in lexicographic
/// order.
[[nodiscard]] std::vector<RationalSegment> contact_edges(const SharedPieces& pieces);

/// Positions of the points that are on no polygon and no segment of a list.
[[nodiscard]] std::vector<RationalPoint> isolated_points(const SharedPieces& pieces,
                                                         const std::vector<RationalSegment>& edges);

}  // namespace strata::contact
