#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/overlap/point_table.h"
#include "core/select/label.h"
#include "core/select/subdivide.h"
#include "strata/mesh.h"

namespace strata {

/// The exact boundary of a result: vertices as numbers of points, triangles with the face from which each comes.
/// Vertices are numbered through `inputs` and then `constructed`. Their positions are different, except those of
/// vertices that one operand lists twice.
struct Boundary {
  std::vector<std::uint32_t> inputs;                    ///< used input vertices, by increasing number
  std::vector<PointId> constructed;                     ///< used constructed points, by increasing number
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< whole faces in input order, then pieces
  std::vector<Source> sources;                          ///< per triangle
  std::vector<Cover> covers;                            ///< by triangle and face, where the rule keeps them
  PointTable points;                                    ///< what the numbers stand for

  [[nodiscard]] PointId point(std::uint32_t vertex) const {
    return vertex < inputs.size() ? inputs[vertex] : constructed[vertex - inputs.size()];
  }
};

/// Merges pieces of one face and gathers them and the whole faces into one boundary. Points that were identified become
/// one vertex. Two streaming passes over the whole faces, in parallel. Throws Cancelled.
[[nodiscard]] Boundary extract(const InputComplex& input, const std::vector<Verdict>& verdicts, Subdivision subdivision,
                               const Monitor& monitor);

}  // namespace strata
