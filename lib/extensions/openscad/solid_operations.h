#pragma once
#include <array>
#include <span>

#include "extensions/openscad/part.h"
#include "strata/options.h"
#include "strata/planar.h"
#include "strata/solid.h"
#include "strata/transform.h"

namespace strata::openscad {

/// A solid part, evaluated. Requires is_solid().
[[nodiscard]] Solid evaluated(const Part& part, const Options& options);

/// The convex hull of solids; that of a union takes the vertices of its primitives, and evaluates nothing. Exact.
[[nodiscard]] Solid hull(std::span<const Part> parts, const Options& options);

/// The section by z = 0, closed: where the solid touches the plane with a face from either side, the face is in it.
[[nodiscard]] planar::Region section_at_zero(const Solid& solid, const Options& options);

/// What lies above or below the solid in the plane z = 0. Exact.
[[nodiscard]] planar::Region shadow(const Solid& solid);

/// Where the arguments of OpenSCAD's resize lead: factors by axis, for a part of that size. A new size that is not
/// positive keeps an axis, or scales it as the largest new size does its own, where `automatic` says so. Axes without
/// extent stay as they are.
[[nodiscard]] RationalPoint resize_factors(const std::array<double, 3>& new_size, const std::array<bool, 3>& automatic,
                                           const RationalPoint& size);

/// Least and largest coordinates, exact.
[[nodiscard]] std::array<RationalPoint, 2> bounding_box(const Solid& solid);

}  // namespace strata::openscad
