#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/zero_area.h"
#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

// Steps common to preparation, repair and diagnosis.
namespace strata {

/// Throws std::invalid_argument when `exact` is not by increasing index of vertices.
void require_increasing_vertices(ExactMeshView mesh);

/// Throws std::invalid_argument when `exact` is not by increasing index or the mesh does not hold the nearest doubles.
void require_nearest_doubles(ExactMeshView mesh, const Monitor& monitor = {});

/// The faces with indices in range and finite coordinates. The others are appended to the defects, as errors or as
/// notes on what was dropped; so many of each kind are listed. O(n).
[[nodiscard]] SourcedTriangles sound_faces(MeshView mesh, Severity severity, std::vector<Defect>& defects,
                                           std::size_t listed = few_defects, const Monitor& monitor = {});

/// Identifies equal vertices with the first of them (-0 = 0). Returns the number of vertices that are equal to an
/// earlier one.
std::uint64_t weld(std::span<const Vertex> vertices, std::vector<Triangle>& triangles, const Monitor& monitor = {});

/// The note that a mesh is closed after equal vertices are identified.
[[nodiscard]] Defect weld_note(std::uint64_t welded);

/// The note on the triangles of zero area that were removed. Requires that there are some.
[[nodiscard]] Defect removal_note(MeshView input, const Removal& removal);

/// Appends the edges whose directed occurrences do not cancel: open where their number is odd, else inconsistent.
void find_open_edges(std::span<const Vertex> vertices, const SourcedTriangles& faces, std::vector<Defect>& defects,
                     std::size_t listed = few_defects, const Monitor& monitor = {});

}  // namespace strata
