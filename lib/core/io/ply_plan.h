#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/ply_channels.h"
#include "core/io/ply_header.h"

namespace strata::io {

/// The use of the records of an element.
enum class PlyRole { none, points, faces, strips };

struct PlyElementPlan {
  const PlyElement* element = nullptr;
  PlyRole role = PlyRole::none;
  std::vector<PlyUse> uses;    ///< per property
  bool is_usual_list = false;  ///< the record is only a list of vertices: a byte for the length, integers of four bytes
};

/// The steps that read the data of a PLY file.
struct PlyPlan {
  std::vector<PlyElementPlan> elements;  ///< those that have data, in order
  std::vector<PlyChannel> channels;
  bool has_corners = false;  ///< some channels are on corners
  std::uint64_t vertex_count = 0;
  std::vector<std::string> notes;  ///< what is left out
};

/// Throws Malformed for elements without the properties that they need. Stores pointers into the header.
[[nodiscard]] PlyPlan plan_ply(const PlyHeader& header);

}  // namespace strata::io
