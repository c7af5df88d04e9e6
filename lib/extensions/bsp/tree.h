#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace strata::bsp {

/// A node of a tree or a leaf.
using Link = std::uint32_t;

/// Leaves: parts of space that are outside and inside.
inline constexpr Link leaf_out = 0xffff'fffe, leaf_in = 0xffff'ffff;

[[nodiscard]] constexpr bool is_leaf(Link link) { return link >= leaf_out; }
[[nodiscard]] constexpr Link leaf(bool is_inside) { return is_inside ? leaf_in : leaf_out; }
[[nodiscard]] constexpr Link other(Link leaf) { return leaf == leaf_in ? leaf_out : leaf_in; }

/// A hyperplane that divides a part of space in two.
struct Node {
  std::uint32_t hyperplane = 0;
  Link minus = leaf_out, plus = leaf_out;
};

/// A binary space partition: convex leaves, each inside or outside.
struct Tree {
  std::vector<Node> nodes;
  Link root = leaf_out;
  std::size_t splits = 0;  ///< facets that were divided during construction
};

/// Appends a node, unless both sides are the same leaf: then the result is that leaf.
inline Link divided(std::vector<Node>& nodes, std::uint32_t hyperplane, Link minus, Link plus) {
  if (minus == plus && is_leaf(minus)) return minus;
  nodes.push_back({hyperplane, minus, plus});
  return static_cast<Link>(nodes.size() - 1);
}

}  // namespace strata::bsp
