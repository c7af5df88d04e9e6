#pragma once
#include <vector>

#include "extensions/contact/region.h"
#include "extensions/contact/shared_pieces.h"
#include "strata/monitor.h"

namespace strata::contact {

/// The connected, maximal facets that polygons form. Corners are numbered as the points of the form.
struct ContactFacets {
  std::vector<RationalPoint> points;
  std::vector<ContactFacet> facets;
};

/// Takes the pieces, and gives their memory back before facets are made: there may be millions of both. Throws
/// Cancelled.
[[nodiscard]] ContactFacets contact_facets(SharedPieces pieces, const Monitor& monitor);

}  // namespace strata::contact
