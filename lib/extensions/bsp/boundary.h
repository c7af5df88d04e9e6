#pragma once
#include <functional>
#include <vector>

#include "extensions/bsp/build.h"
#include "extensions/bsp/piece.h"
#include "extensions/bsp/tree.h"

namespace strata::bsp {

/// The boundary of a tree's region: for every node the parts of its hyperplane that have the inside on one side and the
/// outside on the other, as convex facets with disjoint interiors. Facets may meet in the middle of sides. In the order
/// of the nodes from the root, minus sides first. O(sum over nodes of depth and of leaves next to the node).
template <int D>
[[nodiscard]] std::vector<Facet<D>> boundary(const HyperplaneTable<D>& table, const Tree& tree);

/// The facets in the hyperplane of one node, at the end of a path of half-spaces.
template <int D>
void for_each_facet(const HyperplaneTable<D>& table, const Tree& tree, Link node, std::span<const HalfSpace> path,
                    const std::function<void(const Facet<D>& facet)>& visit);

/// Divides a piece among the leaves below a link that it crosses. A piece that lies in the hyperplane of a node is
/// divided by the minus side first, and its parts outside there by the plus side: parts next to the inside count as
/// inside.
template <int D>
void for_each_part(const HyperplaneTable<D>& table, const Tree& tree, Link link, const Piece<D>& piece,
                   const std::function<void(Link leaf, const Piece<D>& part)>& visit);

/// True when the region is unbounded. O(leaves that reach infinity * depth).
template <int D>
[[nodiscard]] bool reaches_infinity(const HyperplaneTable<D>& table, const Tree& tree);

}  // namespace strata::bsp
