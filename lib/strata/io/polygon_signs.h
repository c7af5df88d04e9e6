#pragma once
#include <array>
#include <span>

#include "strata/exact/sign.h"
#include "strata/mesh/mesh.h"

namespace strata::io {

/// A vertex seen along an axis.
using PlanePoint = std::array<double, 2>;

/// Turn of a, b, c: positive when counter-clockwise, zero when collinear. Exact for all finite doubles.
[[nodiscard]] Sign turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// Sign of the area that a closed polygon encloses: positive when counter-clockwise. Exact. O(n).
[[nodiscard]] Sign area_sign(std::span<const PlanePoint> loop);

/// True when all vertices lie in one plane. Exact. O(n).
[[nodiscard]] bool is_planar(std::span<const Vertex> loop);

}  // namespace strata::io
