#pragma once
#include "extensions/contact/parts.h"

namespace strata::contact {

/// True when the plane of a face, which is one of part a, keeps what parts a and b have in common from having a volume:
/// within the box where they may meet, a is below it and b above. False when that is not so or does not show.
/// theory.md, section 5. O(faces near that box).
[[nodiscard]] bool separates(const Parts& parts, std::uint32_t face, std::uint32_t a, std::uint32_t b);

}  // namespace strata::contact
