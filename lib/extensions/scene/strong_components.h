#pragma once
#include <cstdint>
#include <vector>

namespace strata {

/// The number of its strongly connected component for each node of a directed graph; `next` lists each node's
/// successors. O(nodes + edges), without recursion. Source: Tarjan 1972.
[[nodiscard]] std::vector<std::uint32_t> strong_components(const std::vector<std::vector<std::uint32_t>>& next);

}  // namespace strata
