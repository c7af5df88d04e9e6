#pragma once
#include <cstdint>

#include "extensions/contact/parts.h"
#include "strata/contact.h"

namespace strata::contact {

/// Requires two parts that are apart and not empty. Branch and bound over pairs of boxes with bounds in doubles;
/// rationals decide the remaining pairs. O(n log n) for the trees, plus the pairs of faces that are as near as the
/// nearest up to rounding. Throws Cancelled. theory.md, section 7.
[[nodiscard]] Nearest nearest_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor);

}  // namespace strata::contact
