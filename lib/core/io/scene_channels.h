#pragma once
#include <cstdint>
#include <vector>

#include "core/io/affine_map.h"
#include "core/io/scene_mesh.h"

namespace strata::io {

/// Where the values of a part's channels go.
struct PlacedChannels {
  const ScenePart* part;
  const PointMap* map;
};

/// The channels of all parts, one for each name, for the mesh in which the parts stand one after the other. Channels on
/// different elements are on corners together; of different types, in the widest of them.
[[nodiscard]] std::vector<Channel> joined_channels(const std::vector<PlacedChannels>& parts);

/// How many elements there are.
[[nodiscard]] std::size_t count_of(Element element, std::size_t vertices, std::size_t triangles);

}  // namespace strata::io
