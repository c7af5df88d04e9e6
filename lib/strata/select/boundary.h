#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/kernel/point.h"
#include "strata/select/point_table.h"
#include "strata/select/rule.h"
#include "strata/select/split_faces.h"

namespace strata {

/// The exact boundary of a result: vertices by name, triangles with the face each comes from.
struct Boundary {
  std::vector<PointName> vertices;  ///< distinct points: used input vertices in order, then constructed ones by name
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< whole faces in input order, then pieces
  std::vector<std::uint32_t> sources;                   ///< global face number per triangle
};

/// Gathers what stays. Points of different names that were found equal become one vertex. `table` holds every point of
/// the pieces.
[[nodiscard]] Boundary gather_boundary(const Carriers& carriers, const std::vector<Verdict>& whole,
                                       const SplitFaces& split, const PointTable& table);

}  // namespace strata
