#pragma once
#include <algorithm>
#include <cmath>

#include "strata/mesh.h"

namespace strata {

/// The maximum norm, in doubles.
inline double size(const Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// In the maximum norm, rounded.
inline double distance(const Vertex& p, const Vertex& q) { return size({p[0] - q[0], p[1] - q[1], p[2] - q[2]}); }

}  // namespace strata
