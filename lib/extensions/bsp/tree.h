#pragma once
#include <vector>

#include "strata/bsp.h"

namespace strata::bsp {

/// Appends a node, unless both sides are the same leaf: then that leaf is all there is.
inline Link divided(std::vector<Node>& nodes, std::uint32_t hyperplane, Link minus, Link plus) {
  if (minus == plus && is_leaf(minus)) return minus;
  nodes.push_back({hyperplane, minus, plus});
  return static_cast<Link>(nodes.size() - 1);
}

}  // namespace strata::bsp
