#pragma once
#include <cstdint>
#include <utility>

#include "strata/mesh.h"

namespace strata::test {

/// Adds the faces of another mesh to a mesh, with vertices of their own, and turned round on request.
inline void append(Mesh& mesh, const Mesh& other, bool is_reversed = false) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    if (is_reversed) std::swap(mesh.triangles.back()[1], mesh.triangles.back()[2]);
  }
}

}  // namespace strata::test
