#pragma once
#include "core/kernel/box.h"

namespace strata::contact {

/// A lower bound of half the distance of two boxes; halves do not overflow. Never negative. Within a relative 2^-47 of
/// the distance, at any scale. theory.md, section 7.
[[nodiscard]] double half_distance(const Box& a, const Box& b);

}  // namespace strata::contact
