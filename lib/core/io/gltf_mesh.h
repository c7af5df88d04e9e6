#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/affine_map.h"
#include "core/io/gltf_buffers.h"
#include "core/io/gltf_json.h"
#include "core/io/scene_mesh.h"

namespace strata::io {

/// A mesh of a glTF document: its lists of triangles in one.
struct GltfMesh {
  ScenePart part;
  ExactMap scale = ExactMap::identity();  ///< of normalized integers, which are divided in nodes' transforms
  std::vector<std::string> objects;       ///< names that lists have, to which the channel "object" refers; or none
};

/// What was left out.
struct GltfTally {
  Tally dropped;
  std::uint64_t triangles = 0, lines = 0;
  bool other_attributes = false, targets = false;
};

/// Reads a mesh. Vertices of equal positions become one: where they differ in attributes, these are on corners. Throws
/// Malformed.
[[nodiscard]] GltfMesh read_gltf_mesh(const GltfValue& mesh, GltfBuffers& buffers, const Attributes& attributes,
                                      GltfTally& tally);

}  // namespace strata::io
