#pragma once
#include <vector>

#include "extensions/contact/region.h"
#include "extensions/contact/shared_pieces.h"
#include "strata/measure.h"
#include "strata/monitor.h"

namespace strata::contact {

/// The connected, maximal facets that polygons form. Corners are numbered as the points of the form.
struct ContactFacets {
  std::vector<RationalPoint> points;
  std::vector<ContactFacet> facets;
};

/// The polygons by planes. Throws Cancelled.
[[nodiscard]] CanonicalForm form_of(const SharedPieces& pieces, const Monitor& monitor);

/// Of the polygons of a form, which is all that is needed of them: there may be millions. Throws Cancelled.
[[nodiscard]] ContactFacets contact_facets(CanonicalForm form, const Monitor& monitor);

}  // namespace strata::contact
