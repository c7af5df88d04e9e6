#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/zero_area.h"
#include "strata/errors.h"
#include "strata/mesh.h"

// Steps that preparation, repair and diagnosis have in common.
namespace strata {

/// The faces with indices in range and finite coordinates. The others are appended to the defects, as errors or as
/// notes on what was dropped. O(n).
[[nodiscard]] SourcedTriangles sound_faces(MeshView mesh, Severity severity, std::vector<Defect>& defects);

/// Lets the first of equal vertices stand for all (-0 = 0). Returns how many vertices are equal to an earlier one.
std::uint64_t weld(std::span<const Vertex> vertices, std::vector<Triangle>& triangles);

/// Says that a mesh is closed once equal vertices are one.
[[nodiscard]] Defect weld_note(std::uint64_t welded);

/// Says which triangles of zero area were removed. Some were.
[[nodiscard]] Defect removal_note(MeshView input, const Removal& removal);

/// Appends the edges whose directed occurrences do not cancel: open where their number is odd, else inconsistent.
void find_open_edges(std::span<const Vertex> vertices, const SourcedTriangles& faces, std::vector<Defect>& defects);

}  // namespace strata
