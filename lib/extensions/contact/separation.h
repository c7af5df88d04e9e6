#pragma once
#include "extensions/contact/parts.h"

namespace strata::contact {

/// True when the plane of a face, which is one of part a, proves that the intersection of parts a and b has no volume:
/// within the box where they may meet, a is below it and b above. False when that is not so or is not proven.
/// theory.md, section 5. O(faces near that box).
[[nodiscard]] bool separates(const Parts& parts, std::uint32_t face, std::uint32_t a, std::uint32_t b);

}  // namespace strata::contact
