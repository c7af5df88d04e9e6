#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/io/ply_header.h"

namespace strata::io {

/// What the records of an element are read for.
enum class PlyRole { none, points, faces, strips };

struct PlyElementPlan {
  const PlyElement* element = nullptr;
  PlyRole role = PlyRole::none;
  std::array<std::size_t, 3> axes{};  ///< of points: the properties x, y and z
  std::size_t list = 0;               ///< of faces and strips: the property that lists the vertices
  bool is_usual_list = false;         ///< the list is all there is: a byte for the length, integers of four bytes
};

/// How to read the data of a PLY file.
struct PlyPlan {
  std::vector<PlyElementPlan> elements;  ///< those that have data, in order
  std::uint64_t vertex_count = 0;
};

/// Throws Malformed for elements without the properties that they need. Keeps pointers into the header.
[[nodiscard]] PlyPlan plan_ply(const PlyHeader& header);

}  // namespace strata::io
