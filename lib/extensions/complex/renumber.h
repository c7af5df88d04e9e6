#pragma once
#include <cstdint>
#include <vector>

#include "core/kernel/disjoint_sets.h"
#include "strata/complex.h"

namespace strata::complex {

/// The cells that are merged with each other, and those that are merged into one of higher dimension.
struct Merged {
  explicit Merged(const Cells& cells)
      : edges(cells.count(1)),
        faces(cells.count(2)),
        volumes(cells.count(3)),
        keeps_vertex(cells.count(0), true),
        keeps_edge(cells.count(1), true),
        keeps_face(cells.count(2), true),
        face_of_vertex(cells.count(0), none),
        volume_of_vertex(cells.count(0), none),
        volume_of_edge(cells.count(1), none) {}

  bool changes = false;  ///< anything
  DisjointSets<std::uint32_t> edges, faces, volumes;
  std::vector<bool> keeps_vertex, keeps_edge, keeps_face;
  std::vector<std::uint32_t> face_of_vertex, volume_of_vertex, volume_of_edge;  ///< of isolated ones
};

/// The remaining cells, in the order of their positions: vertices lexicographically, edges by their vertices, faces and
/// volumes by their boundaries; the unbounded cell first among those of the highest dimension. Throws
/// std::invalid_argument for cells that are no complex, as far as this is detected; reads nothing outside of the
/// arrays.
[[nodiscard]] Cells renumbered(const Cells& cells, Merged merged);

}  // namespace strata::complex
