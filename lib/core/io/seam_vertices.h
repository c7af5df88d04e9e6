#pragma once
#include <cstdint>
#include <vector>

#include "core/io/object_faces.h"

namespace strata::io {

/// The vertices of an object for formats in which a vertex has one value of each channel: where corners at a vertex
/// differ, it stands there several times, one after the other.
struct SeamVertices {
  std::vector<std::uint32_t> vertices;  ///< of the mesh
  std::vector<std::uint32_t> corners;   ///< a corner of the mesh for each, whose values it has; none where no face is
  std::vector<Triangle> triangles;      ///< of the object, with indices into `vertices`

  static constexpr std::uint32_t none = 0xffff'ffff;
};

/// `channels` are those of corners to regard; the others do not divide vertices. The object keeps its name and its
/// faces, and gives away the rest. O(corners times faces at a vertex).
[[nodiscard]] SeamVertices divide_at_seams(ObjectFaces& object, const std::vector<const Channel*>& channels);

}  // namespace strata::io
