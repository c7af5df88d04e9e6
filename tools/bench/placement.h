#pragma once
#include <array>

#include "random.h"
#include "strata/mesh.h"

namespace bench {

/// Rows of an orthogonal matrix of determinant 1, up to rounding.
using Rotation = std::array<strata::Vertex, 3>;

[[nodiscard]] Rotation rotation(const strata::Vertex& axis, double degrees);
[[nodiscard]] Rotation random_rotation(Random& random);  ///< all equally likely

[[nodiscard]] strata::Mesh shifted(strata::Mesh mesh, const strata::Vertex& by);
[[nodiscard]] strata::Mesh scaled(strata::Mesh mesh, double factor);
[[nodiscard]] strata::Mesh rotated(strata::Mesh mesh, const Rotation& rotation);  ///< about the origin

/// Rotated about the middle of its bounding box by 30 degrees, about no axis of it, and moved by a tenth of the
/// diagonal: a copy that crosses the mesh in many places, in general position.
[[nodiscard]] strata::Mesh turned_copy(const strata::Mesh& mesh);

}  // namespace bench
