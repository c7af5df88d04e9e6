#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/overlap/point_table.h"
#include "core/select/rule.h"
#include "core/select/split_faces.h"
#include "strata/mesh.h"

namespace strata {

/// The exact boundary of a result: vertices by number, triangles with the face each comes from.
/// Vertices are numbered through `inputs` and then `constructed`; they are distinct points.
struct Boundary {
  std::vector<std::uint32_t> inputs;                    ///< used input vertices, by increasing number
  std::vector<PointId> constructed;                     ///< used constructed points, by increasing number
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< whole faces in input order, then pieces
  std::vector<Source> sources;                          ///< per triangle
};

/// Gathers what stays. Points that were identified become one vertex. Two streaming passes over the whole faces, in
/// parallel.
[[nodiscard]] Boundary gather_boundary(const InputComplex& input, const std::vector<Verdict>& whole,
                                       const std::vector<SplitFace>& split, const PointTable& points);

}  // namespace strata
