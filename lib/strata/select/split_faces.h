#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "strata/kernel/point.h"
#include "strata/layers/local_layers.h"
#include "strata/mesh/monitor.h"
#include "strata/overlap/constraint.h"
#include "strata/select/rule.h"

namespace strata {

/// A triangle that stays, by indices into SplitFace::points and ids; already turned if its face's verdict says so.
struct PieceTriangle {
  std::array<std::uint32_t, 3> v{};
  std::uint8_t outline =
      0;  ///< bit i: across side i (v[i] to v[i + 1]) nothing of this face stays with this orientation
  std::uint8_t carried = 0;  ///< bit i: side i carries a constraint
  bool turned = false;
};

/// What stays of a face that meets others.
struct SplitFace {
  std::uint32_t face = 0;
  std::vector<PointName> points;   ///< as the face names them
  std::vector<std::uint32_t> ids;  ///< the same points in the PointTable, when there is one
  std::vector<PieceTriangle> triangles;
};

/// All that stays of the faces that meet others.
struct SplitFaces {
  std::vector<SplitFace> faces;                        ///< by increasing face
  std::vector<std::pair<PointName, PointName>> equal;  ///< names found to be one point
};

/// Splits every constrained face along its constraints and judges each piece.
///
/// One place of a face is located among the layers of its cell; from there the winding numbers just above the face
/// follow across the constraints, each of which says by how much they change. Below a piece they are those above plus
/// what the piece itself and the coplanar pieces on it contribute. Of coinciding pieces the one of the lowest face
/// counts. `constraints` are grouped by face.
[[nodiscard]] SplitFaces split_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                     std::span<const Constraint> constraints, bool self, const Monitor& monitor);

}  // namespace strata
