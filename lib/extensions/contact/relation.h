#pragma once
#include <cstdint>

#include "extensions/contact/parts.h"
#include "strata/contact.h"

namespace strata::contact {

/// The relation of two parts, exactly. Law: symmetric. An empty part is apart from everything. Nothing is constructed:
/// a pair of faces decides, or a separating plane, or the interior sides of faces. O((n + k) log n) for k pairs of
/// faces whose boxes meet; in most cases much less. Throws Cancelled. theory.md, sections 2 to 5.
[[nodiscard]] Relation relation_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor);

}  // namespace strata::contact
