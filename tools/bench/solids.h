#pragma once
#include <cstdint>
#include <vector>

#include "strata/mesh.h"

namespace bench {

/// A box in 12 triangles.
[[nodiscard]] strata::Mesh box(const strata::Vertex& lower, const strata::Vertex& upper);

/// A box with every side in `parts` by `parts` squares of two triangles. 12 * parts^2 triangles.
[[nodiscard]] strata::Mesh fine_box(const strata::Vertex& lower, const strata::Vertex& upper, std::uint32_t parts);

/// An upright prism over a regular polygon about the z axis, one corner at `angle` from the x axis, in radians.
struct Prism {
  std::uint32_t sides = 3;
  double radius = 1;
  double angle = 0;
  double bottom = 0;
  double top = 1;
};

/// 4 * sides - 4 triangles.
[[nodiscard]] strata::Mesh prism(const Prism& shape);

/// Unit cubes at the integers from 0 to side - 1, face to face.
[[nodiscard]] std::vector<strata::Mesh> cube_grid(unsigned side);

}  // namespace bench
