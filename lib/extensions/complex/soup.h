#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/complex.h"
#include "strata/mesh.h"

namespace strata::complex {

/// A complex in space as triangles, as an operand of an overlay. Numbers of cells are the operand's own; `none` means
/// the cell of next higher dimension around the part. An auxiliary triangle that is no part of a face lies in one
/// volume; some of its edges and vertices are cells.
struct Soup {
  ExactMesh mesh;                                         ///< triangles of positive area
  std::vector<std::uint32_t> vertex_cell;                 ///< per vertex
  std::vector<std::uint32_t> face_cell;                   ///< per triangle
  std::vector<std::array<std::uint32_t, 2>> volume_cell;  ///< per triangle of a face: in front of it, behind it
  std::vector<std::array<std::uint32_t, 3>> edge_cell;    ///< per triangle: on side i, from corner i to the next
  std::uint32_t everywhere = 0;                           ///< the volume, if no triangle is part of a face
};

/// A complex in the plane as segments, for the same purpose.
struct Drawing {
  ExactMesh points;                                     ///< in z = 0; its triangles are not used
  std::vector<std::uint32_t> vertex_cell;               ///< per point
  std::vector<std::array<std::uint32_t, 2>> segments;   ///< different points
  std::vector<std::uint32_t> edge_cell;                 ///< per segment
  std::vector<std::array<std::uint32_t, 2>> face_cell;  ///< per segment: on its left, on its right
  std::uint32_t outside = 0;                            ///< the unbounded face
  bool by_parity = false;  ///< faces alternate: across each segment 0 becomes 1 and 1 becomes 0
};

/// A complex so fine that each of its cells lies in one cell of every operand.
struct Overlay {
  Cells cells;  ///< whose marks are not used
  /// Per dimension, one after the other: for each cell the cells of the operands.
  std::array<std::vector<std::uint32_t>, 4> labels;
};

}  // namespace strata::complex
