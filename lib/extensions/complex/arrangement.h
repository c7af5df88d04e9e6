#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/candidates.h"
#include "core/overlap/point_table.h"
#include "extensions/complex/soup.h"
#include "strata/options.h"

namespace strata::complex {

/// The vertices of all operands at distinct positions, once each, and their triangles.
struct GivenFaces {
  GivenFaces(std::span<const Soup> operands);

  ExactMesh mesh;
  std::vector<std::uint32_t> operand;                   ///< per triangle
  std::vector<std::uint32_t> first;                     ///< per operand: its first triangle
  std::vector<std::vector<std::uint32_t>> vertex_cell;  ///< per operand and vertex of `mesh`
};

/// A part of a face, counter-clockwise as seen from its upper side.
struct Piece {
  std::array<std::uint32_t, 3> v{};
  std::uint32_t face = 0;               ///< the lowest of those that contain it
  std::uint32_t first = 0, covers = 0;  ///< the others, in Arrangement::covers
};

/// A part of a side of a given triangle.
struct SidePart {
  std::array<std::uint32_t, 2> v{};  ///< lower, higher vertex
  std::uint32_t face = 0;
  int side = 0;
};

/// All given faces, divided at their intersections: pieces share whole edges and vertices and nothing else.
struct Arrangement {
  Arrangement(const GivenFaces& faces, const Monitor& monitor);

  Candidates candidates;
  const InputComplex& input;
  PointTable points;
  std::vector<PointId> vertices;         ///< in lexicographic order of positions
  std::vector<std::uint32_t> vertex_of;  ///< of given vertices, in `vertices`
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> covers;
  std::vector<SidePart> side_parts;
  std::vector<std::uint8_t> is_reversed;                          ///< per face: its normal points down
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar;  ///< pairs of faces that touch in one plane
};

}  // namespace strata::complex
