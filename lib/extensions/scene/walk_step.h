#pragma once
#include <cstdint>

#include "core/kernel/filtered_plane.h"
#include "extensions/scene/closed_face.h"
#include "strata/mesh.h"

namespace strata {

/// The effect of a face on the walk from an origin to q.
struct WalkStep {
  int change = 0;   ///< of the winding number of the face's solid
  bool on = false;  ///< q lies on the face
};

/// `side_of_start(plane)`: the side of the face's plane on which the walk starts, 0 if that is not known cheaply.
/// `crossing()`: the change, where q is off the plane. q is given as doubles and as a point.
template <class SideOfStart, class Crossing>
[[nodiscard]] WalkStep walk_step(const InputComplex& input, std::uint32_t face, const Vertex& q, const Point& point,
                                 const SideOfStart& side_of_start, const Crossing& crossing) {
  if (!input.has_rationals()) {
    const auto v = input.face(face);
    const FilteredPlane plane(input.vertex(v[0]), input.vertex(v[1]), input.vertex(v[2]));
    const int side = plane.side(q);
    if (side != 0) return {side == side_of_start(plane) ? 0 : crossing(), false};
  }
  if (side_of_face(input, face, point) == Sign::zero) return {0, holds_point_of_plane(input, face, point)};
  return {crossing(), false};
}

}  // namespace strata
