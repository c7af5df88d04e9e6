#pragma once
/// Simple solids: boxes, tetrahedra, cylinders, cones, spheres, tori and prisms.
///
/// Vertices are doubles. Every result is a solid exactly as it stands: closed, outwards, without triangles of zero
/// area, not crossing itself. Round solids are polyhedra inscribed in the shape named, up to rounding: their vertices
/// are points of it, rounded to within two ulps per coordinate. A circle of n sides has its first corner in direction
/// x, and corners that are mirror images of one another are so in doubles, too; where rounding bends a quadrilateral,
/// it is two triangles. Elsewhere than at the origin: `translated`, `rotated`, `transformed`, which are exact.
///
/// All throw std::invalid_argument for what has no volume, is not finite, has less than 3 sides or more than ten
/// million vertices. O(vertices). Pure functions: thread-safe. The same result wherever std::sin and std::cos are the
/// same. Convex hulls, and geodesic balls that contain the sphere instead (`convex::ball`): convex.h.
#include <array>
#include <cstdint>
#include <span>

#include "strata/solid.h"

namespace strata {

/// The box with opposite corners `lower` and `upper`: 8 vertices, 12 triangles. Requires lower < upper in every
/// coordinate.
[[nodiscard]] Solid make_box(const Vertex& lower, const Vertex& upper);

/// The tetrahedron with these corners, in any order. Throws where they are coplanar, exactly.
[[nodiscard]] Solid make_tetrahedron(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d);

/// A cylinder about the z axis from z = 0 to z = height, as a prism over a regular polygon inscribed in the circle.
/// Requires a radius of at least 1e-290.
[[nodiscard]] Solid make_cylinder(double radius, double height, std::uint32_t sides);

/// A cone about the z axis, with `lower_radius` at z = 0 and `upper_radius` at z = height; one of the two may be 0,
/// which makes a point there. Otherwise as a cylinder.
[[nodiscard]] Solid make_cone(double lower_radius, double upper_radius, double height, std::uint32_t sides);

/// A sphere about the origin with poles on the z axis, and between them max(sides / 2, 2) - 1 circles of latitude at
/// equal angles, each of `sides` corners at equal longitudes. Requires a radius of at least 1e-280.
[[nodiscard]] Solid make_sphere(double radius, std::uint32_t sides);

/// A torus about the z axis: a circle of `tube_radius` whose centre goes round a circle of `radius` in the plane z = 0.
/// `sides` corners on the great circle, `tube_sides` on the small one. Requires 0 < tube_radius < radius. Throws also
/// where rounding makes the torus cross itself (a hole of some ulps); this is checked, in O(n log n).
[[nodiscard]] Solid make_torus(double radius, double tube_radius, std::uint32_t sides, std::uint32_t tube_sides);

/// A polygon in the plane, extruded from z = lower to z = upper. The polygon is simple, in either direction; corners
/// may lie in the middle of straight sides. Throws InputError where it crosses or touches itself or has equal corners;
/// this is checked, exactly, in O(n log n).
[[nodiscard]] Solid make_prism(std::span<const std::array<double, 2>> polygon, double lower, double upper);

}  // namespace strata
