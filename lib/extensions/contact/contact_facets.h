#pragma once
#include <vector>

#include "extensions/contact/region.h"
#include "extensions/contact/shared_pieces.h"

namespace strata::contact {

/// The connected facets of which polygons are parts, maximal. Corners are numbered as in the points of the form.
struct ContactFacets {
  std::vector<RationalPoint> points;
  std::vector<ContactFacet> facets;
};

[[nodiscard]] ContactFacets contact_facets(const SharedPieces& pieces);

}  // namespace strata::contact
