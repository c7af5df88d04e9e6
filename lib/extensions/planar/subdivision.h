#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/planar/arrangement.h"

namespace strata::planar {

/// The vertices of an arrangement at which chains end.
enum class ChainEnds {
  nodes,         ///< those through which not exactly one pass of a ring goes, and every ring's least vertex
  all_vertices,  ///< every vertex: a chain is a piece
};

/// The subdivision of the plane by the pieces of closed rings of segments: nodes, chains between them, half-edges
/// around nodes, cycles around faces, and the containment of cycles in faces.
///
/// A chain is a run of pieces of one ring between two nodes. Chains that coincide (they are single pieces then) are one
/// *edge*, named by the lowest of them. Half-edge 2c goes along chain c, 2c + 1 back; each has a face to its left. Only
/// half-edges of edges are linked: `next` follows the border of the face to the left, `cycle_of` numbers these borders.
/// A *component* is a connected set of edges. Its outer cycle lies in a face of another component, or in the unbounded
/// face; all other cycles bound one face each. Components are in lexicographic order of their least vertices.
struct Subdivision {
  struct Chain {
    std::uint32_t first = 0, last = 0;  ///< its pieces, `last` included; it wraps around its ring if last < first
    std::uint32_t ring = 0;
  };
  struct Component {
    std::uint32_t start = 0;  ///< a half-edge of the outer cycle
    std::uint32_t container =
        none;  ///< a half-edge with the face that contains the component; none: the unbounded face
  };

  std::vector<std::uint32_t> first_piece_of_ring;  ///< and the count of pieces
  std::vector<Chain> chains;
  std::vector<std::uint32_t> edge_of;       ///< of every chain: the lowest chain that coincides with it
  std::vector<std::uint8_t> is_opposite;    ///< of every chain: it runs against that chain
  std::vector<std::uint32_t> first_around;  ///< of every vertex, in `around`
  std::vector<std::uint32_t> end_around;
  std::vector<std::uint32_t> around;  ///< outgoing half-edges of edges, counter-clockwise from just above straight down
  std::vector<std::uint32_t> next;    ///< of every half-edge of an edge
  std::vector<std::uint32_t> cycle_of;  ///< of every half-edge of an edge
  std::uint32_t cycles = 0;
  std::vector<Component> components;

  [[nodiscard]] bool is_edge(std::uint32_t chain) const { return edge_of[chain] == chain; }
  [[nodiscard]] std::span<const std::uint32_t> around_vertex(std::uint32_t v) const {
    return {around.data() + first_around[v], around.data() + end_around[v]};
  }
  [[nodiscard]] std::uint32_t pieces_of(std::uint32_t chain) const {
    const auto [first, last, ring] = chains[chain];
    const std::uint32_t around_ring = first_piece_of_ring[ring + 1] - first_piece_of_ring[ring];
    return last + 1 - first + (last < first ? around_ring : 0);
  }
  /// Calls visit(piece) for every piece of a chain, in the ring's order.
  template <class Visit>
  void for_each_piece(std::uint32_t chain, const Visit& visit) const {
    const Chain& c = chains[chain];
    for (std::uint32_t k = c.first;;
         k = k + 1 == first_piece_of_ring[c.ring + 1] ? first_piece_of_ring[c.ring] : k + 1) {
      visit(k);
      if (k == c.last) return;
    }
  }
};

/// The vertex at which a half-edge starts.
[[nodiscard]] inline std::uint32_t origin(const Arrangement& a, const Subdivision& s, std::uint32_t half_edge) {
  const Subdivision::Chain& c = s.chains[half_edge >> 1];
  return half_edge & 1 ? a.pieces[c.last][1] : a.pieces[c.first][0];
}

/// Subdivides the plane by rings: ring r has the segments first_segment[r] .. first_segment[r + 1] - 1, each starting
/// where the one before ends, the first where the last ends. O((n + k) log n). `patience` is that of `Nesting`.
[[nodiscard]] Subdivision subdivide(const Arrangement& a, std::span<const std::uint32_t> first_segment,
                                    ChainEnds ends = ChainEnds::nodes, std::size_t patience = usual_patience);

}  // namespace strata::planar
