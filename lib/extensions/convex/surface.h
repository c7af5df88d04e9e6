#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/convex.h"
#include "strata/mesh.h"
#include "strata/monitor.h"

namespace strata::convex {

/// A side between two faces. Seen from outside, walking from `from` to `to`, `left` is on the left.
struct SurfaceEdge {
  std::uint32_t from = 0, to = 0;
  std::uint32_t left = 0, right = 0;     ///< faces; `no_face` for a segment, which has none
  std::array<std::uint32_t, 2> fans{};   ///< at `from` and at `to`
  std::array<std::uint32_t, 2> third{};  ///< corners of `left` and `right` that are not on the line of the edge
};

/// One sheet of a surface about a vertex: the edges there, counter-clockwise seen from outside.
struct Fan {
  struct Spoke {
    std::uint32_t edge = 0;
    bool outgoing = false;  ///< the vertex is the edge's `from`
  };
  std::uint32_t vertex = 0;
  std::vector<Spoke> spokes;
};

/// The boundary of a solid or of a polytope of dimension 0..3, with its neighbourhoods. A polygon has two faces, back
/// to back; a segment has an edge without faces; a point is a fan without spokes. Where more than two faces meet in an
/// edge, the two sides of each wedge of the solid are neighbours, as if the solid were cut open along the edge. A
/// vertex of several sheets has several fans.
struct Surface {
  static constexpr std::uint32_t no_face = 0xffff'ffff;

  ExactMesh points;                               ///< its vertices; no triangles
  std::vector<std::vector<std::uint32_t>> faces;  ///< loops, counter-clockwise from outside
  std::vector<SurfaceEdge> edges;
  std::vector<Fan> fans;
  bool is_convex = false;
  int dimension = 3;
};

/// The surface of a closed mesh with winding numbers 0 and 1 and no triangles of zero area, as solids have. Throws
/// std::invalid_argument where the faces about an edge are not those of a solid, and Cancelled. O(n log n).
[[nodiscard]] Surface surface_of(const ExactMesh& solid, const Monitor& monitor = {});

/// The surface of a polytope that is not empty. Throws Cancelled. O(n log n).
[[nodiscard]] Surface surface_of(const Polytope& polytope, const Monitor& monitor = {});

}  // namespace strata::convex
