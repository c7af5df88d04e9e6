#pragma once
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {

/// A partition from a tree that comes from elsewhere: nodes whose hyperplane does not divide their part of space are
/// replaced by the child in which that part lies, equal leaves become one. Exact. O(nodes * depth^2) at worst.
template <int D>
[[nodiscard]] Partition<D> pruned(const HyperplaneTable<D>& table, const Tree& tree);

}  // namespace strata::bsp
