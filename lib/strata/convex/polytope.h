#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "strata/mesh/exact_mesh.h"

namespace strata::convex {

/// The convex hull of finitely many points of space, of any dimension: nothing (-1), a point, a segment, a convex
/// polygon, a solid (3). Every vertex is extreme: none lies between others.
struct Polytope {
  int dimension = -1;
  std::vector<Vertex> vertices;    ///< in lexicographic order of their exact places, rounded to nearest doubles
  std::vector<ExactVertex> exact;  ///< those for which rounding changed something, by increasing index
  /// Dimension 3: the maximal facets, counter-clockwise as seen from outside. Dimension 2: the polygon, one loop, in
  /// either direction. No facets below.
  std::vector<std::vector<std::uint32_t>> facets;

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;  ///< O(log exact.size())
};

/// The boundary of a polytope of dimension 3 as triangles, each facet a fan; without triangles below. O(size).
[[nodiscard]] ExactMesh mesh_of(const Polytope& polytope);

/// What is wrong with it, exactly, in words: an order that is not one, vertices that are not extreme, facets that are
/// not maximal, not planar or not convex, dimension. Empty for what this room returns. O(vertices * facets).
[[nodiscard]] std::vector<std::string> violations(const Polytope& polytope);

}  // namespace strata::convex
