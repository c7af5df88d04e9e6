#pragma once
#include <cstdint>
#include <vector>

#include "strata/mesh.h"

namespace bench {

/// Long differences: the first mesh minus all others, one after the other or at once.

/// A sphere of 20,480 triangles minus three tori of 4,096 about the axes and six spheres of 5,120 at their ends.
[[nodiscard]] std::vector<strata::Mesh> nine_cuts();

/// A block minus 223 sweeps of a round tool over hills: every sweep is a straight piece, and shares the tool's whole
/// outline with the next one of its row, exactly; rows overlap.
[[nodiscard]] std::vector<strata::Mesh> terrain();

/// A ball minus so many capsules of 256 triangles, which lie anywhere on its upper half and point anywhere.
[[nodiscard]] std::vector<strata::Mesh> dome(std::uint32_t capsules);

/// A torus about the z axis. 2 * around * across triangles.
[[nodiscard]] strata::Mesh torus(double radius, double thickness, std::uint32_t around, std::uint32_t across);

/// About the z axis from -half_length to half_length, half spheres on either end. 4 * sides * rings
/// triangles; rings: of one half sphere, its rim included.
[[nodiscard]] strata::Mesh capsule(double half_length, double radius, std::uint32_t sides, std::uint32_t rings);

}  // namespace bench
