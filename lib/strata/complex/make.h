#pragma once
#include <array>
#include <span>
#include <vector>

#include "strata/complex/selective_complex.h"
#include "strata/csg/solid.h"

namespace strata::complex {

/// Whether what bounds a set of full dimension within its affine hull belongs to it.
enum class Border : std::uint8_t { closed, open };

/// A solid, with its boundary or without. O(n log n).
[[nodiscard]] SelectiveComplex of_solid(const Solid& solid, Border border = Border::closed);

/// The convex hull of one to `dimension` + 1 affinely independent points: a point, segment, triangle or tetrahedron.
/// An open one is without its own border; a point has none. In the plane z must be 0.
/// Throws InputError for coordinates that are not finite and for corners that are not independent.
[[nodiscard]] SelectiveComplex simplex(int dimension, std::span<const Vertex> corners, Border border = Border::closed);

/// Closed triangles, segments and points, of which any may meet any other.
struct Simplices {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<std::uint32_t> points;
};

/// Their union in space, in one arrangement. Throws InputError for coordinates that are not finite, indices out of
/// range, triangles of zero area and segments of no length.
[[nodiscard]] SelectiveComplex unite_closed(const Simplices& simplices);

/// A point of the plane.
using Point2 = std::array<double, 2>;

/// What is within loops in the plane an odd number of times, its boundary added or taken away: the polygons of a
/// polyloop. Loops may cross themselves and each other. Throws InputError for coordinates that are not finite.
[[nodiscard]] SelectiveComplex polygon(std::span<const std::vector<Point2>> loops, Border border = Border::closed);

}  // namespace strata::complex
