#pragma once
// The implementation of partitions: include/strata/bsp.h only declares the type.
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/hyperplane_table.h"
#include "extensions/bsp/boundary.h"
#include "extensions/bsp/build.h"
#include "extensions/bsp/tree.h"
#include "strata/bsp.h"

namespace strata::bsp {

/// The data of a partition.
template <int D>
struct Partition<D>::Data {
  HyperplaneTable<D> table;
  Tree tree;
};

/// The hyperplanes of a region's nodes, by number.
template <int D>
[[nodiscard]] const HyperplaneTable<D>& table_of(const Partition<D>& region) {
  return region.data().table;
}

template <int D>
[[nodiscard]] const Tree& tree_of(const Partition<D>& region) {
  return region.data().tree;
}

/// A partition from a tree over a table. Every node must divide its part of space; `pruned` ensures this.
template <int D>
[[nodiscard]] Partition<D> partition_from(HyperplaneTable<D> table, Tree tree) {
  using Data = typename Partition<D>::Data;
  return Partition<D>(Shared<Data>::make(Data{std::move(table), std::move(tree)}));
}

/// The half-space on the inner side of an oriented hyperplane.
template <int D>
[[nodiscard]] Partition<D> behind(const OrientedHyperplane<D>& hyperplane);

/// The intersection of such half-spaces: `Partition::convex`.
template <int D>
[[nodiscard]] Partition<D> behind_all(std::span<const OrientedHyperplane<D>> hyperplanes);

/// Convex facets with disjoint interiors, bounded or not; the region's table has their corners.
template <int D>
[[nodiscard]] std::vector<Facet<D>> facets_of(const Partition<D>& region) {
  return boundary(table_of(region), tree_of(region));
}

/// The parts of a piece over the region's table that are in the region or on its boundary, convex and with disjoint
/// interiors.
template <int D>
[[nodiscard]] std::vector<Piece<D>> part_inside(const Partition<D>& region, const Piece<D>& piece);

/// Converts a facet of a region's tree to its public form. Throws std::domain_error when it is not bounded.
template <int D>
[[nodiscard]] BoundaryFacet<D> boundary_facet(const HyperplaneTable<D>& table, const Facet<D>& facet);

/// The coefficients of a hyperplane whose normal points to the plus side, or to the minus side.
template <int D>
[[nodiscard]] AffineForm<D> form_of(const Hyperplane<D>& hyperplane, bool looks_to_plus);

/// Visits every inside leaf as a convex cell: its facets have their outer side away from it and extend to the frame
/// where it is unbounded. Leaves are in the order of the tree, minus sides first. O(leaves * depth^2).
template <int D>
void for_each_inside_leaf(const Partition<D>& region,
                          const std::function<void(const std::vector<Facet<D>>& facets)>& visit);

/// Visits the nodes of a tree in the order in which they are met from a point: the point's side of a node comes before
/// the node, the other side after it. Of two nodes no part of the later one hides a part of the earlier one. A point in
/// a hyperplane counts as on the minus side.
template <int D>
void for_each_node_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                                 const std::function<void(Link node)>& visit);

/// The double nearest to the square root of q >= 0.
[[nodiscard]] double nearest_square_root(const Rational& q);

}  // namespace strata::bsp
