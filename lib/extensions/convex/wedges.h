#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/bsp/build.h"
#include "strata/mesh.h"

namespace strata::convex {

/// The angle of a solid at an edge, between two triangles of its boundary. An edge with 2k triangles has k of them.
struct Wedge {
  std::array<std::uint32_t, 2> faces;     ///< the triangles that bound it
  std::array<std::uint32_t, 2> planes;    ///< two planes that contain the edge's line
  std::array<std::uint32_t, 2> vertices;  ///< of the edge; one number for coincident ones
  std::array<HyperplaneMeet<3>, 2> ends;  ///< their positions
  bool is_reflex = false;                 ///< larger than 180 degrees
};

/// All wedges of a solid, in the order of its edges. `facets` are the triangles of `mesh` (`bsp::triangle_facets`), all
/// of them. Equal vertices may be listed more than once. Exact; expected O(n log n).
[[nodiscard]] std::vector<Wedge> wedges_of(const HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets,
                                           ExactMeshView mesh, const Monitor& monitor = {});

}  // namespace strata::convex
