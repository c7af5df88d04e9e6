#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/planar.h"

namespace strata {

/// The loops in which a plane crosses some triangles of a closed mesh, as seen from in front with the inside on the
/// left. `plane.is_in_front(v)` says on which side a vertex is, those in the plane counting as behind it;
/// `plane.add_crossing(a, b, loops)` adds the point of the edge from a, not in front, to b, in front. Triangles that do
/// not cross the plane are passed over. Where more than two triangles meet in an edge, loops may change over from one
/// to another there: winding numbers about points are the same.
/// O(k log k) for k triangles.
template <class PlaneOf>
[[nodiscard]] planar::Loops cut(std::span<const Triangle> triangles, std::span<const std::uint32_t> numbers,
                                const PlaneOf& plane);

/// The edges through which loops enter and leave triangles.
class CutEdges {
 public:
  /// A triangle that crosses the plane: seen from outside its boundary goes from in front to behind along one edge, and
  /// back along another. The edges are given by the vertex behind and the one in front.
  void add(std::uint32_t enter_behind, std::uint32_t enter_front, std::uint32_t leave_behind,
           std::uint32_t leave_front);
  /// Calls `visit(behind, front)` for the points of a loop, and `end()` at its end, for every loop. Throws LogicError
  /// where the mesh is not closed.
  template <class Visit, class End>
  void for_each_loop(const Visit& visit, const End& end);

 private:
  struct Crossing {
    std::uint64_t edge = 0;
    std::uint32_t triangle = 0;

    friend auto operator<=>(const Crossing&, const Crossing&) = default;
  };
  [[nodiscard]] std::vector<std::uint32_t> successors();

  std::vector<Crossing> enters_, leaves_;
};

template <class Visit, class End>
void CutEdges::for_each_loop(const Visit& visit, const End& end) {
  const std::vector<Crossing> enters = enters_;
  const std::vector<std::uint32_t> next = successors();
  std::vector<bool> is_done(next.size(), false);
  for (std::uint32_t first = 0; first < next.size(); ++first) {
    if (is_done[first]) continue;
    for (std::uint32_t t = first; !is_done[t]; t = next[t]) {
      is_done[t] = true;
      const std::uint64_t edge = enters[t].edge;
      visit(static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge));
    }
    end();
  }
}

template <class PlaneOf>
planar::Loops cut(std::span<const Triangle> triangles, std::span<const std::uint32_t> numbers, const PlaneOf& plane) {
  CutEdges edges;
  for (const std::uint32_t n : numbers) {
    const Triangle& t = triangles[n];
    const std::array<bool, 3> in_front{plane.is_in_front(t[0]), plane.is_in_front(t[1]), plane.is_in_front(t[2])};
    if (in_front[0] == in_front[1] && in_front[1] == in_front[2]) continue;
    std::size_t down = 0, up = 0;  // the corners from which the boundary goes behind, and comes back
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (in_front[i] && !in_front[j]) down = i;
      if (!in_front[i] && in_front[j]) up = i;
    }
    edges.add(t[(down + 1) % 3], t[down], t[up], t[(up + 1) % 3]);
  }
  planar::LoopsBuilder loops;
  edges.for_each_loop([&](std::uint32_t behind, std::uint32_t front) { plane.add_crossing(behind, front, loops); },
                      [&] { loops.end_loop(); });
  return loops.finish();
}

}  // namespace strata
