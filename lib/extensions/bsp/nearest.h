#pragma once
#include <optional>

#include "extensions/bsp/partition.h"

namespace strata::bsp {

/// A point of the boundary that is nearest to another point.
template <int D>
struct NearestPoint {
  RationalVector<D> point;
  Rational squared_distance;
  double distance = 0;  ///< correctly rounded; negative for points inside, 0 on the boundary
};

/// The nearest point of the boundary; of several the one met first, front to back. Nothing when there is no boundary.
/// Exact. Visits the leaf of p and whatever is nearer than the best so far: O(depth^2) for points near the boundary.
template <int D>
[[nodiscard]] std::optional<NearestPoint<D>> nearest_boundary_point(const Partition<D>& region,
                                                                    const RationalVector<D>& p);

/// The double nearest to the square root of q >= 0.
[[nodiscard]] double nearest_square_root(const Rational& q);

}  // namespace strata::bsp
