#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/mesh.h"

namespace strata::io {

/// A face as listed in a file: a loop, then its holes.
struct LoopFace {
  std::vector<std::uint32_t> corners;  ///< vertices of all loops, one loop after the other
  std::vector<std::size_t> ends;       ///< where each loop ends in `corners`

  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t k) const {
    const std::size_t first = k == 0 ? 0 : ends[k - 1];
    return std::span(corners).subspan(first, ends[k] - first);
  }
};

/// Vertices, and the exact positions, by increasing index, of those that are not doubles. Indices are in range.
struct ExactVertices {
  std::span<const Vertex> rounded;
  std::span<const ExactVertex> exact;
};

/// Appends the triangles of a planar face, counter-clockwise like its first loop. Every corner and every side of the
/// loops belongs to a triangle. Coincident vertices of the face are identified with the first of them. Loops may meet
/// themselves and each other in corners. A stretch that occurs once in each direction (a keyhole) does not bound the
/// face. No triangle is degenerate, none overlaps another. All decisions are exact. Returns the defect of the face,
/// without a subject ("has corners that are not in one plane"), or an empty text; if there is a defect, nothing is
/// appended. O(n log n) decisions for n corners.
[[nodiscard]] std::string divide_face(const LoopFace& face, const ExactVertices& vertices,
                                      std::vector<Triangle>& triangles);

}  // namespace strata::io
