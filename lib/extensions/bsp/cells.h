#pragma once
#include <functional>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// Shows every inside leaf as a convex cell: its facets look away from it and reach to the frame where it has no end.
/// Leaves come in the order of the tree, minus sides first. O(leaves * depth^2).
template <int D>
void for_each_cell(const Partition<D>& region, const std::function<void(const std::vector<Facet<D>>& facets)>& visit);

}  // namespace strata::bsp
