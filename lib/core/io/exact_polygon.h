#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/mesh.h"

namespace strata::io {

/// A face as a file lists it: a loop, then its holes.
struct LoopFace {
  std::vector<std::uint32_t> corners;  ///< vertices of all loops, one loop behind the other
  std::vector<std::size_t> ends;       ///< where each loop ends in `corners`

  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t k) const {
    const std::size_t first = k == 0 ? 0 : ends[k - 1];
    return std::span(corners).subspan(first, ends[k] - first);
  }
};

/// Vertices with their exact places, by increasing index, where these are not doubles. Indices are in range.
struct ExactVertices {
  std::span<const Vertex> rounded;
  std::span<const ExactVertex> exact;
};

/// Appends the triangles of a planar face, counter-clockwise as its first loop is. Every corner and every side of the
/// loops is one of triangles; vertices of the face at one place count as the first of them. Loops may meet themselves
/// and each other in corners; a stretch that they run along once in each direction does not bound the face (keyholes).
/// No triangle is degenerate, none overlaps another. All decisions are exact.
/// Returns what is wrong with the face, without its subject ("has corners that are not in one plane"), or nothing; then
/// nothing is appended. O(n log n) decisions for n corners.
[[nodiscard]] std::string divide_face(const LoopFace& face, const ExactVertices& vertices,
                                      std::vector<Triangle>& triangles);

}  // namespace strata::io
