#pragma once
/// Solids and meshes that JavaScript has a number of: their addresses.
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "strata/solid.h"

namespace strata::web {

using Handle = std::uintptr_t;

[[nodiscard]] inline unsigned keep(Solid solid) {
  return static_cast<unsigned>(reinterpret_cast<Handle>(new Solid(std::move(solid))));
}
[[nodiscard]] inline const Solid& solid_of(Handle handle) { return *reinterpret_cast<const Solid*>(handle); }
[[nodiscard]] inline std::vector<Solid> solids_of(const Handle* handles, std::size_t count) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < count; ++i) solids.push_back(solid_of(handles[i]));
  return solids;
}

/// Flat arrays of JavaScript as a mesh.
[[nodiscard]] inline Mesh mesh_of(const double* coordinates, std::size_t vertices, const std::uint32_t* corners,
                                  std::size_t triangles) {
  Mesh mesh;
  mesh.vertices.resize(vertices);
  mesh.triangles.resize(triangles);
  for (std::size_t i = 0; i < 3 * vertices; ++i) mesh.vertices[i / 3][i % 3] = coordinates[i];
  for (std::size_t i = 0; i < 3 * triangles; ++i) mesh.triangles[i / 3][i % 3] = corners[i];
  return mesh;
}

}  // namespace strata::web
