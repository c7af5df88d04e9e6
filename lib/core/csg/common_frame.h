#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "strata/transform.h"

namespace strata {

/// A map and how many vertices it moves.
struct PlacedVertices {
  const Transform* map = nullptr;
  std::size_t count = 0;
};

/// A map F, one of those given, such that F^-1 times the others have much shorter coefficients than these: solids that
/// are rotated as a whole are cheaper to combine before the rotation. None, where that does not pay. Linear in the
/// number of maps, except for products of at most some hundred matrices.
[[nodiscard]] std::optional<Transform> common_frame(std::span<const PlacedVertices> placed);

}  // namespace strata
