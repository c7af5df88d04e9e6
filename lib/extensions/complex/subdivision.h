#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "strata/mesh.h"

namespace strata::complex {

/// Points and segments of the plane z = 0 in a triangulation of a large triangle around them, divided at their
/// intersections. All exact: equal points are one vertex, crossings are vertices, overlapping segments share sides.
struct Subdivision {
  struct Side {
    std::int32_t neighbour = -1;  ///< the triangle across, or -1
    /// Segments that contain it, and whether their direction is that from its first to its last vertex.
    std::vector<std::pair<std::uint32_t, bool>> segments;
  };
  struct Part {
    std::array<std::uint32_t, 3> v{};  ///< counter-clockwise; the corners around everything are `none`
    std::array<Side, 3> sides;
  };

  /// Throws std::out_of_range where points are so far away that no triangle of doubles contains them.
  Subdivision(const ExactMesh& points, std::span<const std::array<std::uint32_t, 2>> segments);

  ExactMesh vertices;                    ///< in lexicographic order of positions; without triangles
  std::vector<std::uint32_t> vertex_of;  ///< per point
  std::vector<Part> parts;
  std::uint32_t outside = 0;  ///< a part that no segment separates from infinity
};

}  // namespace strata::complex
