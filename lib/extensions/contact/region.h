#pragma once
#include <cstdint>

#include "extensions/contact/parts.h"
#include "strata/contact.h"

namespace strata::contact {

/// The contact region of two parts, in coordinates of the model. Requires that their interiors do not meet. O(k log k)
/// for k pairs of faces that meet, in rationals, plus pairs of remaining edges and points with objects near them.
/// Throws Cancelled.
[[nodiscard]] ContactRegion region_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor);

}  // namespace strata::contact
