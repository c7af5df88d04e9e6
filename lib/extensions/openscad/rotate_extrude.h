#pragma once
#include "extensions/openscad/tessellation.h"
#include "strata/options.h"
#include "strata/planar.h"
#include "strata/solid.h"

namespace strata::openscad {

/// The arguments of OpenSCAD's rotate_extrude.
struct RotateExtrusion {
  double angle = 360;  ///< degrees, counter-clockwise as seen from above; at most a full turn either way
  double start = 180;  ///< where the first profile stands, from the x axis
  Resolution resolution;
};

/// True where a region has points on both sides of the y axis, which cannot be turned about it.
[[nodiscard]] bool crosses_axis(const planar::Region& region);

/// The solid that a region passes over when it is stood up (y becomes z) and turned about the z axis, in as many steps
/// as a circle of its largest distance has in that angle. Vertices are doubles; each edge makes two triangles per step,
/// from its first corner before to its second corner after. Points on the axis stay one vertex, edges on it have no
/// faces. Requires a finite angle that is not 0, and a region that does not cross the axis. Throws
/// std::length_error beyond ten million corners, and what Solid throws.
[[nodiscard]] Solid rotate_extrude(const planar::Region& region, const RotateExtrusion& extrusion,
                                   const Options& options);

}  // namespace strata::openscad
