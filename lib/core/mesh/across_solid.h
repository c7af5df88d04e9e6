#pragma once
#include <span>
#include <utility>

#include "core/exact/sign.h"
#include "core/mesh/edge_table.h"

namespace strata {

/// Where a face lies as seen from another one at the same edge, going round the edge into the solid.
enum class WedgeAngle { less, straight, more };  ///< than 180 degrees

/// Which faces bound a solid's interior on both sides, where more than two meet in an edge. `outer_side(use, other)` is
/// the side, positive outside, of the plane of `use`'s face on which the corner of `other`'s face lies that is not on
/// the edge. The faces are those of a solid: winding numbers 0 and 1, with area.
template <class OuterSide>
class AcrossSolid {
 public:
  explicit AcrossSolid(OuterSide outer_side) : outer_side_(std::move(outer_side)) {}

  [[nodiscard]] WedgeAngle angle(const EdgeUse& from, const EdgeUse& to) const {
    const Sign side = outer_side_(from, to);
    return side == Sign::negative ? WedgeAngle::less : side == Sign::zero ? WedgeAngle::straight : WedgeAngle::more;
  }

  /// The face on the other side of the wedge of the solid behind `from`: the first one met. Every use of an edge is
  /// that of exactly one other. O(uses).
  [[nodiscard]] const EdgeUse& operator()(const EdgeUse& from, std::span<const EdgeUse> around) const {
    const EdgeUse* best = nullptr;
    for (const EdgeUse& g : around)
      if (g.forward != from.forward && (best == nullptr || is_before(from, g, *best))) best = &g;
    return *best;
  }

 private:
  /// True when g comes before h in going round from `from`.
  [[nodiscard]] bool is_before(const EdgeUse& from, const EdgeUse& g, const EdgeUse& h) const {
    const WedgeAngle to_g = angle(from, g), to_h = angle(from, h);
    if (to_g != to_h) return to_g < to_h;
    if (to_g == WedgeAngle::straight) return false;
    // Within one half-turn h is less than 180 degrees beyond g, or g beyond h. Both face against `from`, so that what
    // is next beyond g is on its outer side.
    return outer_side_(g, h) == Sign::positive;
  }

  OuterSide outer_side_;
};

}  // namespace strata
