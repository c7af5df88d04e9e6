#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/kernel/point.h"
#include "core/mesh/pool.h"
#include "core/overlap/constraint.h"
#include "core/select/rule.h"
#include "core/winding/winding_oracle.h"
#include "strata/options.h"

namespace strata {

/// A triangle that stays, by indices into SplitFace::points; already turned if its face's verdict says so.
struct PieceTriangle {
  std::array<std::uint32_t, 3> v{};
  std::uint8_t loop = 0;  ///< bit i: across side i (v[i] to v[i + 1]) nothing of this face stays with this orientation
  std::uint8_t carried = 0;  ///< bit i: side i carries a constraint
  bool turned = false;
};

/// What stays of a face that meets others. The arrays are in pools.
struct SplitFace {
  std::uint32_t face = 0;
  bool may_merge = false;  ///< it is divided, and by more than that two solids cross
  std::span<PointId> points;
  std::span<PieceTriangle> triangles;
  /// Points constructed in this face, numbered from the end of the PointTable until they are in it.
  std::span<SymbolicPoint> constructed;
};

/// One pool per thread.
using Pools = tbb::enumerable_thread_specific<Pool>;

/// All that stays of the faces that meet others, by increasing face.
///
/// Splits every constrained face along its constraints and judges each piece.
///
/// One place of a face is located by its surroundings; from there the winding numbers just above the face
/// follow across the constraints, each of which says by how much they change. Below a piece they are those above plus
/// what the piece itself and the coplanar pieces on it contribute. Of coinciding pieces the one of the lowest face
/// counts. Points constructed by the way become points of the table, and what was found equal is identified there.
[[nodiscard]] std::vector<SplitFace> split_faces(const InputComplex& input, const WindingOracle& oracle,
                                                 const Rule& rule, const Intersections& intersections, bool self,
                                                 PointTable& points, Pools& pools, const Monitor& monitor);

}  // namespace strata
