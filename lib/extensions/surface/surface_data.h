#pragma once
#include <utility>
#include <vector>

#include "strata/surface.h"

namespace strata {

/// What a surface consists of. The mesh has no two vertices at one position and no triangles without area.
struct Surface::Data {
  ExactMesh mesh;
  std::vector<Source> sources;
  std::vector<Defect> notes;
  Attributes attributes;
};

/// A surface of triangles that fulfil what Surface::Data says.
[[nodiscard]] Surface surface_of(ExactMesh mesh, std::vector<Source> sources);

}  // namespace strata
