#include "extensions/scene/common_origin.h"

#include <algorithm>

#include "core/cells/walk.h"

namespace strata {

Windings CommonOrigin::around(const Point& q, std::uint32_t own) const {
  Windings windings;
  for (std::uint32_t o = 0; o < coverings_.size(); ++o)
    if (o != own) walk(o, q, {}, windings);
  return windings;
}

Windings CommonOrigin::above(std::uint32_t face, const Point& q, std::span<const std::uint32_t> covering) const {
  Windings windings;
  for (std::uint32_t o = 0; o < coverings_.size(); ++o) walk(o, q, covering, windings);
  // The walk ends at the face. From below it continues through the covering faces to the upper side.
  const Origin& origin = coverings_.front()->origin();
  const Sign start =
      origin.is_point() ? side_of_origin(input_, face, origin.at) : side_of_infinity(input_, face, origin.at);
  if (start == Sign::positive) return windings;
  for (const std::uint32_t g : covering)
    windings.add(input_.operand_of_face(g), -to_int(same_orientation(input_, face, g)));
  return windings;
}

/// Adds the winding number about one operand: the origin's plus the changes along the walk.
void CommonOrigin::walk(std::uint32_t operand, const Point& q, std::span<const std::uint32_t> through_q,
                        Windings& windings) const {
  const SignedCovering& covering = *coverings_[operand];
  const Origin& origin = covering.origin();
  int w = covering.windings_of_origin()[0];
  const std::uint32_t first = input_.first_face(operand);
  const auto visit = [&](std::uint32_t local) {
    const std::uint32_t face = first + local;
    if (std::find(through_q.begin(), through_q.end(), face) != through_q.end()) return;  // not crossed
    w += origin.is_point() ? crossing(input_, face, origin.at, q) : crossing_from_infinity(input_, face, origin.at, q);
  };
  for (const std::uint32_t f : covering.index().faces_at_origin()) visit(f);
  covering.index().for_each_towards(q.at, visit);
  windings.add(operand, w);
}

}  // namespace strata
