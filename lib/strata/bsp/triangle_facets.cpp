#include "strata/bsp/triangle_facets.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <utility>

#include "strata/exact/lattice.h"
#include "strata/kernel/homogeneous.h"

namespace strata::bsp {
namespace {

/// Makes facets of triangles: their walls are planes along the axis nearest to the normal, so that a wall meets the
/// triangle's plane in the edge's line whatever lies beyond the edge.
class TriangleFacets {
 public:
  TriangleFacets(HyperplaneTable<3>& table, ExactMeshView mesh) : table_(table), mesh_(mesh) {
    Lattice lattice;
    for (const Vertex& v : mesh.mesh.vertices)
      for (const double x : v) lattice.add(x);
    unit_ = lattice.unit();
    if (mesh.exact.empty() && lattice.bits() <= most_bits_of_narrow) {
      narrow_ = on_lattice<Narrow>(lattice);
      return;
    }
    wide_ = on_lattice<Integer>(lattice);
    for (const ExactVertex& e : mesh.exact) wide_[e.vertex] = place_of(e.position);
  }

  std::vector<Facet<3>> all() {
    std::vector<Facet<3>> facets;
    facets.reserve(mesh_.mesh.triangles.size());
    for (const Triangle& t : mesh_.mesh.triangles) {
      const HPlane<Integer> plane =
          found([&](const auto& at) { return strata::plane_through(at[t[0]], at[t[1]], at[t[2]]); });
      if (plane.a != 0 || plane.b != 0 || plane.c != 0) facets.push_back(facet(t, plane));
    }
    return facets;
  }

 private:
  using Narrow = WideInt<4>;
  static constexpr int most_bits_of_narrow = 83;  ///< of coordinates b: coefficients have at most 3 b + 5, and a sign

  template <class Int>
  [[nodiscard]] std::vector<HPoint<Int>> on_lattice(const Lattice& lattice) const {
    std::vector<HPoint<Int>> places;
    places.reserve(mesh_.mesh.vertices.size());
    for (const auto& [x, y, z] : mesh_.mesh.vertices)
      places.push_back({lattice.integer<Int>(x), lattice.integer<Int>(y), lattice.integer<Int>(z), Int(1), true});
    return places;
  }

  /// The plane that `find` makes of places of vertices.
  template <class Find>
  [[nodiscard]] HPlane<Integer> found(const Find& find) const {
    if (narrow_.empty()) return find(wide_);
    const HPlane<Narrow> plane = find(narrow_);
    return {to_integer(plane.a), to_integer(plane.b), to_integer(plane.c), to_integer(plane.d)};
  }

  [[nodiscard]] HPoint<Integer> place_of(const RationalPoint& p) const {
    Integer w = 1;
    for (const Rational& x : p) w = lcm(w, denominator(x));
    std::array<Integer, 3> n;
    for (std::size_t i = 0; i < 3; ++i) n[i] = numerator(p[i]) * (w / denominator(p[i]));
    const auto shift = static_cast<unsigned>(std::abs(unit_));
    if (unit_ > 0) w <<= shift;
    if (unit_ < 0)
      for (Integer& x : n) x <<= shift;
    return {n[0], n[1], n[2], w, w == 1};
  }

  /// From units of the lattice to units of the mesh.
  [[nodiscard]] OrientedHyperplane<3> oriented(const HPlane<Integer>& plane) const {
    std::array<Integer, 4> form{plane.a, plane.b, plane.c, plane.d};
    const auto shift = static_cast<unsigned>(std::abs(unit_));
    if (unit_ > 0) form[3] <<= shift;
    if (unit_ < 0)
      for (std::size_t i = 0; i < 3; ++i) form[i] <<= shift;
    return oriented_hyperplane<3>(form);
  }

  Facet<3> facet(Triangle t, const HPlane<Integer>& through) {
    OrientedHyperplane<3> plane = oriented(through);
    if (plane.is_turned) std::swap(t[1], t[2]);
    const auto axis = static_cast<int>(plane.hyperplane.longest_axis());
    Piece<3> piece;
    piece.hyperplane = table_.add(std::move(plane.hyperplane));
    for (const std::uint32_t v : t) note(piece.hyperplane, v);
    for (std::size_t i = 0; i < 3; ++i) piece.walls.push_back(wall(t[i], t[(i + 1) % 3], axis));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<std::uint32_t, 3> names{piece.hyperplane, piece.walls[(i + 2) % 3], piece.walls[i]};
      piece.corners.push_back(is_given(t[i]) ? HyperplaneTable<3>::given(names, mesh_.mesh.vertices[t[i]])
                                             : table_.meet(names));
    }
    return {std::move(piece), !plane.is_turned};
  }

  /// Through an edge along an axis. Most are asked for by both faces at the edge.
  std::uint32_t wall(std::uint32_t p, std::uint32_t q, int axis) {
    const auto [low, high] = std::minmax(p, q);
    const auto [known, is_new] = walls_[static_cast<std::size_t>(axis)].try_emplace(std::uint64_t{low} << 32U | high);
    if (is_new) {
      const HPlane<Integer> plane = found([&](const auto& at) { return plane_along_axis(at[p], at[q], axis); });
      known->second = table_.add(oriented(plane).hyperplane);
      for (const std::uint32_t v : {p, q}) note(known->second, v);
    }
    return known->second;
  }

  void note(std::uint32_t plane, std::uint32_t v) {
    if (is_given(v)) table_.note(plane, mesh_.mesh.vertices[v]);
  }
  [[nodiscard]] bool is_given(std::uint32_t v) const {
    const auto at = std::lower_bound(mesh_.exact.begin(), mesh_.exact.end(), v,
                                     [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
    return at == mesh_.exact.end() || at->vertex != v;
  }

  HyperplaneTable<3>& table_;
  ExactMeshView mesh_;
  int unit_ = 0;                        ///< of the lattice, as an exponent
  std::vector<HPoint<Narrow>> narrow_;  ///< of vertices, in its units; empty if the lattice does not allow it
  std::vector<HPoint<Integer>> wide_;   ///< the same, if that is empty
  std::array<std::unordered_map<std::uint64_t, std::uint32_t>, 3> walls_;  ///< by axis and edge
};

}  // namespace

std::vector<Facet<3>> triangle_facets(HyperplaneTable<3>& table, ExactMeshView mesh) {
  return TriangleFacets(table, mesh).all();
}

}  // namespace strata::bsp
