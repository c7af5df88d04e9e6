#pragma once
#include <optional>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// Length, area or volume, exact; nothing when it is infinite. Unbounded regions are infinite: they are regular.
template <int D>
[[nodiscard]] std::optional<Rational> size(const Partition<D>& region);

/// The centre of mass, exact; nothing when the region is empty or unbounded.
template <int D>
[[nodiscard]] std::optional<RationalVector<D>> barycentre(const Partition<D>& region);

/// Of the boundary: number of points, length or area; facets to a few units in the last place, summed in
/// doubles; infinity when it has no end.
template <int D>
[[nodiscard]] double boundary_size(const Partition<D>& region);

}  // namespace strata::bsp
