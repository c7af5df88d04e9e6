#pragma once
#include "strata/mesh.h"

/// Closed meshes about the origin, oriented outwards, in model units. `n` is the resolution, at least 3.
namespace shapes {

/// Axis-parallel, from -size/2 to size/2.
[[nodiscard]] strata::Mesh box(const strata::Vertex& size);

/// Meridians and circles of latitude: 2n and n - 1; 4n (n - 1) triangles.
[[nodiscard]] strata::Mesh sphere(double radius, unsigned n);

/// Around the z axis: 2n by n quads.
[[nodiscard]] strata::Mesh torus(double radius, double tube, unsigned n);

/// Along the z axis, from -height/2 to height/2.
[[nodiscard]] strata::Mesh cylinder(double radius, double height, unsigned n);

/// A cylinder with n teeth that rise from `inner` to `outer`.
[[nodiscard]] strata::Mesh gear(double inner, double outer, double height, unsigned n);

/// An L with its outer corner at the origin, legs of length `leg` along x and y, `width` wide along z.
[[nodiscard]] strata::Mesh bracket(double leg, double thickness, double width);

}  // namespace shapes
