#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/zero_area.h"
#include "strata/mesh.h"

namespace strata {

/// A loop of open edges that triangles were added to.
struct FilledHole {
  std::vector<std::uint32_t> loop;   ///< its vertices
  std::uint32_t first_triangle = 0;  ///< of those that fill it: one for each vertex but two
  std::uint32_t face_beside = 0;     ///< the source of a face at its first edge
};

/// The sum over all edges of how far their directed uses are from cancelling: 0 for a closed chain. O(n log d).
[[nodiscard]] std::uint64_t open_uses(std::span<const Vertex> vertices, std::span<const Triangle> triangles);

/// Adds triangles between given vertices, so that the directed edges of all triangles cancel: the chain is closed. The
/// edges that are missing form loops, because the boundary of a boundary is zero; every loop is divided where it comes
/// back to one of its vertices, and filled with the triangulation of least area, of those that dynamic programming
/// finds (Barequet and Sharir 1995); of loops with more vertices than `most_optimal`, ears of least area are cut off
/// until so many are left. Areas are compared in doubles, the same on all machines. Triangles may cross one another and
/// the rest, or have zero area. Their source is a face at the loop's first edge. Requires finite coordinates. O(n log
/// d), and per loop of k edges O(k log k + min(k, most_optimal)^3).
std::vector<FilledHole> fill_holes(std::span<const Vertex> vertices, SourcedTriangles& faces);
inline constexpr std::size_t most_optimal = 150;

}  // namespace strata
