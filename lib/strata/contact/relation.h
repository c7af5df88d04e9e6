#pragma once
#include <array>
#include <cstddef>

#include "strata/contact/parts.h"

namespace strata::contact {

/// How two closed regular solids lie to each other.
enum class Relation {
  apart,       ///< they have no point in common
  contact,     ///< their boundaries meet, their interiors do not
  interfering  ///< their interiors meet: what they have in common has a volume
};

/// apart, contact, interfering.
[[nodiscard]] constexpr const char* name(Relation relation) {
  constexpr std::array names{"apart", "contact", "interfering"};
  return names[static_cast<std::size_t>(relation)];
}

/// The relation of two parts, exactly. Law: symmetric. An empty part is apart from everything. Nothing is constructed:
/// a pair of faces decides, or a separating plane, or what is just below the faces. O((n + k) log n) for k pairs of
/// faces whose boxes meet; mostly much less. theory.md, sections 2 to 5.
[[nodiscard]] Relation relation_of(const Parts& parts, std::uint32_t a, std::uint32_t b);

}  // namespace strata::contact
