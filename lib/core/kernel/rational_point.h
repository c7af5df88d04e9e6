#pragma once
#include <span>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/kernel/homogeneous.h"
#include "strata/mesh.h"

namespace strata {

/// A rational point over the least common denominator of its coordinates.
[[nodiscard]] HPoint<Integer> homogeneous(const RationalPoint& p);

/// A point of doubles over a power of two, the least that serves.
[[nodiscard]] HPoint<Integer> homogeneous(const Vertex& p);
/// Points of doubles over one power of two.
[[nodiscard]] std::vector<HPoint<Integer>> homogeneous(std::span<const Vertex> points);

/// The point of three doubles, exactly.
[[nodiscard]] RationalPoint to_rational(const Vertex& p);

/// The coordinates of a homogeneous point, w != 0.
[[nodiscard]] RationalPoint rational(const HPoint<Integer>& p);

}  // namespace strata
