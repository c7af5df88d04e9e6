#pragma once
#include <vector>

#include "extensions/bsp/piece.h"
#include "extensions/bsp/tree.h"
#include "strata/options.h"

namespace strata::bsp {

/// A convex part of the boundary of a region: the region is on one side of it, near it.
template <int D>
struct Facet {
  Piece<D> piece;
  bool faces_plus = false;  ///< the outer side is the plus side
};

/// The tree of the region that facets bound. They must be the whole boundary of a region, without overlaps, bounded or
/// not; no facets: the empty region. Facets in one plane share one node. Hyperplanes are added to the table.
///
/// Every node takes the hyperplane with the lowest estimate of the work below it, among those of some facets and, for
/// large nodes, axis-parallel ones through the median corner. The estimate is the sum of m log m over both sides, where
/// m counts facets, and divided facets count on both sides. So divisions are avoided first, and then sides are
/// balanced. A convex solid, where every facet has all others on one side, gets a balanced tree instead of a list.
/// Expected O(n log^2 n) for n facets of which few are divided; theory.md, "When trees are large", has the bad cases.
/// Throws Cancelled.
template <int D>
[[nodiscard]] Tree built(HyperplaneTable<D>& table, std::vector<Facet<D>> facets, const Monitor& monitor = {});

}  // namespace strata::bsp
