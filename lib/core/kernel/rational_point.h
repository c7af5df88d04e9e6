#pragma once
#include "core/exact/big_integer.h"
#include "core/kernel/homogeneous.h"
#include "strata/mesh.h"

namespace strata {

/// A rational point over the least common denominator of its coordinates.
[[nodiscard]] HPoint<Integer> homogeneous(const RationalPoint& p);

/// The coordinates of a homogeneous point, w != 0.
[[nodiscard]] RationalPoint rational(const HPoint<Integer>& p);

}  // namespace strata
