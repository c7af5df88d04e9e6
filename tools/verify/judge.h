#pragma once
#include <filesystem>

#include "strata/mesh.h"
#include "verify/case.h"
#include "verify/outcome.h"

namespace verify {

/// The yardstick for results that are not exact. It decides about reports on engines, about no geometry.
///
/// With the engine's unit roundoff u and the largest coordinate M of the operands, vertices may be d = 256 u M away
/// from where they belong. To the first order the volume then changes by no more than d times the area, and the area by
/// no more than 2 d times the length of all edges (faces that meet in an edge of the true result turn about it; what
/// happens inside a planar facet cancels), plus d^2 for each triangle.
struct Yardstick {
  strata::Rational distance;  ///< d
};

[[nodiscard]] Yardstick yardstick_for(const Case& c, double unit_roundoff);

/// What a result is worth. Closed and inverted are told exactly, after vertices with equal coordinates are joined.
/// `exact`: the canonical form and the volume are as expected, and no faces meet but along shared edges and vertices.
/// `rounded`: volume and area within the yardstick; components and Euler characteristic as expected, or what they can
/// be where touching sheets are listed apart (NonManifold); no faces cross. Requires `c.expected`.
[[nodiscard]] Verdict judge(const strata::ExactMesh& result, const Case& c, const Yardstick& yardstick);

/// The same for a file; one that cannot be read is invalid.
[[nodiscard]] Verdict judge_file(const std::filesystem::path& file, const Case& c, const Yardstick& yardstick);

}  // namespace verify
