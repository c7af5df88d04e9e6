#pragma once
#include <cstdint>

#include "strata/mesh.h"

namespace bench {

/// The icosahedron, its triangles split into four and pushed out to the unit sphere again and again.
/// 20 * 4^levels triangles.
[[nodiscard]] strata::Mesh icosphere(unsigned levels);

/// The icosahedron with every side in `frequency` parts, pushed out to the unit sphere. 20 * frequency^2 triangles.
[[nodiscard]] strata::Mesh geodesic_sphere(std::uint32_t frequency);

/// Every vertex moved towards or away from the origin by up to `amplitude` of its distance.
[[nodiscard]] strata::Mesh with_noise(strata::Mesh mesh, double amplitude, std::uint64_t seed);

/// A unit sphere with about a hundred bumps and dents on it; seen whole from its middle.
[[nodiscard]] strata::Mesh bumpy_sphere(std::uint32_t frequency);

}  // namespace bench
