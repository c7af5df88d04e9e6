#pragma once
/// Is a mesh the boundary of a solid? Complete, exact answers.
///
/// Of the options, `threads` and `cancel` count. The result does not depend on the number of threads. All throw
/// Cancelled, and std::length_error for more than 2^32 - 2 vertices or faces.
#include <cstddef>
#include <vector>

#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/options.h"

namespace strata {

/// Diagnosis without intersecting faces: all defects except self-intersection and inside-out shells. Lists so many of
/// each kind with coordinates and face numbers, and counts the rest.
/// O(n log n).
[[nodiscard]] std::vector<Defect> diagnose(MeshView mesh, std::size_t listed = few_defects,
                                           const Monitor& monitor = {});
/// The same for exact positions. Nothing is repaired: with rationals, triangles of zero area are errors. Throws
/// std::invalid_argument when `exact` is not by increasing index of vertices.
[[nodiscard]] std::vector<Defect> diagnose(ExactMeshView mesh, std::size_t listed = few_defects,
                                           const Monitor& monitor = {});

/// What happens to a mesh that becomes an operand of this class: the notes on what is resolved, or the defects of the
/// InputError by which it is refused. Self-intersections are searched for class `automatic` only. O(n log n).
[[nodiscard]] std::vector<Defect> defects_as_operand(const ExactMesh& mesh, InputClass input,
                                                     const Options& options = {});

/// Complete diagnosis: coordinates are finite, indices in range, no triangle is degenerate or doubled, every edge is
/// closed and consistently oriented, no two triangles meet other than in common edges and vertices (equal coordinates
/// are one vertex), winding numbers are 0 and 1. Law: no defect of severity `error` is listed exactly when the mesh
/// bounds a solid. An empty mesh bounds the empty solid: this is noted, and no error. Of each kind so many are listed,
/// each with the count of all. When a defect makes later questions meaningless (an index out of range), these are not
/// asked. Exact for all doubles. O((n + k) log n) for k pairs of triangles that meet.
[[nodiscard]] std::vector<Defect> check(MeshView mesh, const Options& options = {}, std::size_t listed = few_defects);
/// The same for rational vertices. Throws std::invalid_argument when `exact` is not by increasing index, or the mesh
/// does not hold the nearest doubles.
[[nodiscard]] std::vector<Defect> check(ExactMeshView mesh, const Options& options = {},
                                        std::size_t listed = few_defects);

/// True when no two triangles meet other than in common edges and vertices. The mesh need not be closed. False also
/// where a coordinate is not finite, an index out of range, or a triangle degenerate or doubled. Exact; the same
/// complexity.
[[nodiscard]] bool is_embedded(MeshView mesh, const Options& options = {});
[[nodiscard]] bool is_embedded(ExactMeshView mesh, const Options& options = {});

}  // namespace strata
