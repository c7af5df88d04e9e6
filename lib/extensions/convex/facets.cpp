#include "extensions/convex/facets.h"

#include <tbb/parallel_for.h>

namespace strata::convex {
namespace {

/// Traces the rims of facets, which are the edges between triangles of different planes.
class Rims {
 public:
  explicit Rims(const Quickhull& hull) : hull_(hull), flat_(hull.faces().size(), 0) {
    tbb::parallel_for(std::size_t{0}, flat_.size(), [&](std::size_t i) {
      const auto f = static_cast<std::uint32_t>(i);
      if (!hull.is_used(f)) return;
      for (std::uint32_t edge = 0; edge < 3; ++edge)
        if (f < hull.faces()[f].neighbor[edge] && hull.is_flat(f, edge)) flat_[f] |= bit(edge);
    });
  }

  /// Calls `corner(point)` for the start of every edge of every rim, counter-clockwise, and `end()` after each rim.
  template <class Corner, class End>
  void walk(const Corner& corner, const End& end) const {
    std::vector<unsigned char> walked(flat_.size(), 0);
    for (std::uint32_t start = 0; start < flat_.size(); ++start) {
      if (!hull_.is_used(start)) continue;
      for (std::uint32_t first = 0; first < 3; ++first) {
        if ((walked[start] & bit(first)) != 0 || is_flat(start, first)) continue;
        std::uint32_t f = start, edge = first;
        do {
          walked[f] |= bit(edge);
          corner(hull_.faces()[f].corner[edge]);
          go_on(f, edge);
        } while (f != start || edge != first);
        end();
      }
    }
  }

 private:
  static unsigned char bit(std::uint32_t edge) { return static_cast<unsigned char>(1u << edge); }

  [[nodiscard]] bool is_flat(std::uint32_t f, std::uint32_t edge) const {
    const std::uint32_t beyond = hull_.faces()[f].neighbor[edge];
    if (f < beyond) return (flat_[f] & bit(edge)) != 0;
    return (flat_[beyond] & bit(Quickhull::edge_to(hull_.faces()[beyond], f))) != 0;
  }

  /// Advances from an edge of a rim to the next one, around the corner between them.
  void go_on(std::uint32_t& f, std::uint32_t& edge) const {
    edge = (edge + 1) % 3;
    while (is_flat(f, edge)) {
      const std::uint32_t beyond = hull_.faces()[f].neighbor[edge];
      edge = (Quickhull::edge_to(hull_.faces()[beyond], f) + 1) % 3;
      f = beyond;
    }
  }

  const Quickhull& hull_;
  std::vector<unsigned char> flat_;  ///< a bit per edge to a face of higher number
};

}  // namespace

/// A point of the boundary is extreme when it is on three facets or more; on two it is inside an edge.
Loops maximal_facets(const Quickhull& hull, std::uint32_t points) {
  const Rims rims(hull);
  std::vector<std::uint32_t> facets_at(points, 0);
  rims.walk([&](std::uint32_t p) { ++facets_at[p]; }, [] {});
  Loops loops;
  rims.walk(
      [&](std::uint32_t p) {
        if (facets_at[p] >= 3) loops.corners.push_back(p);
      },
      [&] { loops.ends.push_back(loops.corners.size()); });
  return loops;
}

}  // namespace strata::convex
