#pragma once
/// Is a mesh the boundary of a solid?
#include <vector>

#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// Diagnosis of everything that can be told without intersecting faces: all defects but self-intersection and
/// inside-out shells. Lists the first few of each kind with coordinates and face numbers, and counts the rest.
/// O(n log n).
[[nodiscard]] std::vector<Defect> diagnose(MeshView mesh);
/// The same for exact places, of which none is repaired: among rationals triangles of zero area are errors.
[[nodiscard]] std::vector<Defect> diagnose(ExactMeshView mesh);

/// What is resolved of a mesh, or why it is refused, when it becomes an operand that is declared so: the notes of its
/// Solid, or the defects of the InputError. Self-intersections are not looked for. O(n log n).
[[nodiscard]] std::vector<Defect> defects_as_operand(const ExactMesh& mesh, InputClass input);

/// Complete diagnosis: indices, coordinates, closed, oriented, no face meets another but along shared edges and
/// vertices, winding numbers 0 and 1. Empty exactly when the mesh bounds a solid (notes aside).
/// Exact. O((n + k) log n) for k meeting pairs.
[[nodiscard]] std::vector<Defect> check(MeshView mesh, const Options& options = {});
/// The same for rational vertices. Throws std::invalid_argument as `prepare_exact` does.
[[nodiscard]] std::vector<Defect> check(ExactMeshView mesh, const Options& options = {});

/// True when no two faces meet but along shared edges and vertices, by exact predicates on the doubles given.
[[nodiscard]] bool is_embedded(MeshView mesh, const Options& options = {});
[[nodiscard]] bool is_embedded(ExactMeshView mesh, const Options& options = {});

}  // namespace strata
