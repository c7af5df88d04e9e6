#pragma once
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {

/// A partition from an arbitrary tree: nodes whose hyperplane does not divide their part of space are replaced by the
/// child that contains that part, equal leaves become one. Exact. O(nodes * depth^2) in the worst case.
template <int D>
[[nodiscard]] Partition<D> pruned(const HyperplaneTable<D>& table, const Tree& tree);

}  // namespace strata::bsp
