#pragma once
#include <span>

#include "strata/mesh.h"

namespace strata {

/// True when a plane is found that has these points strictly on one side and those on the other. Certain, even if each
/// coordinate is half a unit in the last place away from where the point is; not found for sets very near each other.
/// The directions tried are those of Gilbert, Johnson, Keerthi (1988): each is the way from one hull to the other in
/// what is known of them so far. O(points) for each, at most 32.
[[nodiscard]] bool are_separated(std::span<const Vertex> points, std::span<const Vertex> others);

}  // namespace strata
