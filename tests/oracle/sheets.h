#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "strata/mesh.h"

namespace strata::oracle {

/// A closed surface, oriented outwards, every edge in exactly two triangles, every vertex in one fan, no two
/// vertices at one place.
struct Sheet {
  std::vector<RationalPoint> points;
  std::vector<Triangle> triangles;
};

/// Divides a closed boundary into sheets whose parity is the solid. The boundary may share edges and vertices
/// between several sheets. Nothing when some part touches itself in every pairing that was tried.
[[nodiscard]] std::optional<std::vector<Sheet>> manifold_sheets(const ExactMesh& mesh);

/// The tetrahedra over all faces from the most used vertex, as sheets; flat ones are left out.
[[nodiscard]] std::vector<Sheet> tetrahedra_over_faces(const ExactMesh& mesh);

}  // namespace strata::oracle
