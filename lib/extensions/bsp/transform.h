#pragma once
#include <functional>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// x -> matrix x + shift.
template <int D>
struct AffineMap {
  std::array<RationalVector<D>, D> matrix{};  ///< rows
  RationalVector<D> shift{};
};

/// The image of a region, exact: every hyperplane is mapped, the tree stays. O(nodes). Coefficients grow by those of
/// the map. Throws std::invalid_argument when the map is singular.
template <int D>
[[nodiscard]] Partition<D> transformed(const Partition<D>& region, const AffineMap<D>& map);

/// Shows the nodes of a tree in the order in which they are met from a point: what is on the point's side of a node
/// comes before the node, what is on the other side behind it. Of two nodes no part of the later one hides a part of
/// the earlier one. A point in a hyperplane counts as on the minus side.
template <int D>
void for_each_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                            const std::function<void(Link node)>& visit);

}  // namespace strata::bsp
