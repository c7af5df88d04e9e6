#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/zero_area.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata {

/// A loop of open edges, in which no vertex comes twice.
struct Hole {
  std::vector<std::uint32_t> loop;  ///< its vertices, three or more
  std::uint32_t face_beside = 0;    ///< the source of a face at its first edge
};

/// The sum over all edges of how far their directed uses are from cancelling: 0 for a closed chain. O(n log d).
[[nodiscard]] std::uint64_t open_uses(std::span<const Vertex> vertices, std::span<const Triangle> triangles,
                                      const Monitor& monitor = {});

/// The edges that are missing for a closed chain, as loops: there are such, because the boundary of a boundary is zero.
/// A loop is divided where it comes back to one of its vertices. O(n log d).
[[nodiscard]] std::vector<Hole> find_holes(std::span<const Vertex> vertices, const SourcedTriangles& faces,
                                           const Monitor& monitor = {});

/// Edges within a filling that faces have already.
enum class RepeatedEdges : bool { allowed, avoided };

/// Adds triangles between the vertices of loops, for each one fewer than vertices by two: with all holes that
/// `find_holes` finds, the directed edges of all triangles cancel. A filling is the triangulation of least area, of
/// those that dynamic programming finds (Barequet and Sharir 1995), and, where repeated edges are avoided, of those
/// with the fewest edges within that faces have already. Of loops with more vertices than `most_optimal`, ears of least
/// area are cut off until so many are left. Areas are compared in doubles, the same on all machines. Triangles may
/// cross one another and the rest, or have zero area. Their source is the face beside. Requires finite coordinates. O(n
/// log d), and per loop of k edges O(k log k + min(k, most_optimal)^3).
void fill_holes(std::span<const Vertex> vertices, std::span<const Hole> holes, SourcedTriangles& faces,
                RepeatedEdges repeated_edges = RepeatedEdges::allowed, const Monitor& monitor = {});
inline constexpr std::size_t most_optimal = 150;

}  // namespace strata
