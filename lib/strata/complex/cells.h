#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "strata/exact/rational.h"
#include "strata/kernel/exact_vertex.h"
#include "strata/mesh/mesh.h"

namespace strata::complex {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A cell by dimension and number: a vertex, an edge, a face or a volume.
struct Cell {
  int dimension = 0;
  std::uint32_t index = 0;

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// Where a face ends in an edge. An edge has two wings of one face where that face lies on both of its sides.
struct Wing {
  std::uint32_t edge = 0, face = 0;
  bool left = false;  ///< of the edge, looking from its lower vertex to its higher one, with the face's upper side up

  friend auto operator<=>(const Wing&, const Wing&) = default;
};

/// A cell that lies in a cell of higher dimension and on no edge or face of it.
struct Isolated {
  std::uint32_t cell = 0, in = 0;

  friend auto operator<=>(const Isolated&, const Isolated&) = default;
};

/// The cells of a linear complex and how they bound one another, as plain arrays. Cells are open in their affine hulls,
/// connected and pairwise disjoint, and cover the plane (z = 0) or all of space.
///
/// The upper side of a face is the one to which the normal with a positive first non-zero coordinate points; in the
/// plane it is that of z. Vertices are in lexicographic order of their exact places, so the first end of an edge is its
/// lower one, and collinear edges run the same way.
struct Cells {
  int dimension = 3;  ///< of the space: 2 or 3
  std::vector<Vertex> points;
  std::vector<ExactVertex> exact;                   ///< those that are no doubles, by increasing vertex
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< lower, higher vertex
  std::vector<std::uint32_t> plane;                 ///< per face; at one edge, faces in one plane have equal numbers
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< per face: volumes above and below; in space
  std::vector<Wing> wings;                          ///< sorted
  std::vector<Isolated> vertices_in_faces, vertices_in_volumes, edges_in_volumes;  ///< sorted
  std::array<std::vector<std::uint8_t>, 4> marks;                                  ///< 1 in the set; per dimension

  [[nodiscard]] std::uint32_t count(int d) const {
    return static_cast<std::uint32_t>(marks[static_cast<std::size_t>(d)].size());
  }
  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size())

  /// In all arrays but `plane`, which only tells planes apart.
  friend bool operator==(const Cells& a, const Cells& b);
};

}  // namespace strata::complex
