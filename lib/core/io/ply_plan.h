#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/io/ply_header.h"

namespace strata::io {

/// The use of the records of an element.
enum class PlyRole { none, points, faces, strips };

struct PlyElementPlan {
  const PlyElement* element = nullptr;
  PlyRole role = PlyRole::none;
  std::array<std::size_t, 3> axes{};  ///< of points: the properties x, y and z
  std::size_t list = 0;               ///< of faces and strips: the property that lists the vertices
  bool is_usual_list = false;         ///< the record is only this list: a byte for the length, integers of four bytes
};

/// The steps that read the data of a PLY file.
struct PlyPlan {
  std::vector<PlyElementPlan> elements;  ///< those that have data, in order
  std::uint64_t vertex_count = 0;
};

/// Throws Malformed for elements without the properties that they need. Stores pointers into the header.
[[nodiscard]] PlyPlan plan_ply(const PlyHeader& header);

}  // namespace strata::io
