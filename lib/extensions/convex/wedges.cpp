#include "extensions/convex/wedges.h"

#include <algorithm>

#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"

namespace strata::convex {
namespace {

class WedgeFinder {
 public:
  WedgeFinder(const HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets, ExactMeshView mesh)
      : table_(table), facets_(facets), mesh_(mesh), is_given_(mesh.mesh.vertices.size(), true) {
    for (const ExactVertex& e : mesh.exact) is_given_[e.vertex] = false;
  }

  std::vector<Wedge> all() {
    const std::vector<std::uint32_t> first = equal_vertices(mesh_);
    triangles_.assign(mesh_.mesh.triangles.begin(), mesh_.mesh.triangles.end());
    for (Triangle& t : triangles_)
      for (std::uint32_t& v : t) v = first[v];
    const std::vector<EdgeUse> uses = edge_table(triangles_, mesh_.mesh.vertices.size());
    std::vector<Wedge> wedges;
    for_each_edge(uses, [&](std::span<const EdgeUse> around) {
      for (const EdgeUse& f : around)
        if (f.forward) wedges.push_back(wedge(f, across_solid(f, around)));
    });
    return wedges;
  }

 private:
  /// The angle from one face to another at the same edge, through the solid.
  enum class Turn { less, straight, more };  ///< than 180 degrees

  [[nodiscard]] std::uint32_t apex(const EdgeUse& use) const {
    return mesh_.mesh.triangles[use.triangle][(use.corner + 2U) % 3];
  }
  /// Positive on the outer side of a triangle.
  [[nodiscard]] Sign outer_side(std::uint32_t triangle, std::uint32_t vertex) const {
    const bsp::Facet<3>& f = facets_[triangle];
    const Sign side = is_given_[vertex] ? table_.side(f.piece.hyperplane, mesh_.mesh.vertices[vertex])
                                        : table_.side(f.piece.hyperplane, mesh_.position(vertex));
    return f.faces_plus ? side : -side;
  }
  [[nodiscard]] Turn orientation(const EdgeUse& from, const EdgeUse& to) const {
    const Sign side = outer_side(from.triangle, apex(to));
    return side == Sign::negative ? Turn::less : side == Sign::zero ? Turn::straight : Turn::more;
  }

  /// The face that bounds the solid on the other side of its wedge behind `from`: the first one in rotation.
  [[nodiscard]] const EdgeUse& across_solid(const EdgeUse& from, std::span<const EdgeUse> around) const {
    const EdgeUse* best = nullptr;
    for (const EdgeUse& g : around)
      if (g.forward != from.forward && (best == nullptr || is_before(from, g, *best))) best = &g;
    return *best;
  }
  /// True when g is before h in the rotation that starts at `from`.
  [[nodiscard]] bool is_before(const EdgeUse& from, const EdgeUse& g, const EdgeUse& h) const {
    const Turn to_g = orientation(from, g), to_h = orientation(from, h);
    if (to_g != to_h) return to_g < to_h;
    if (to_g == Turn::straight) return false;
    // Within one half-turn h is less than 180 degrees beyond g, or g beyond h. Both have their outer side towards
    // `from`, so the next face beyond g is on its outer side.
    return outer_side(g.triangle, apex(h)) == Sign::positive;
  }

  [[nodiscard]] Wedge wedge(const EdgeUse& f, const EdgeUse& g) const {
    const bsp::Facet<3>& facet = facets_[f.triangle];
    const std::uint32_t plane = facet.piece.hyperplane, other = facets_[g.triangle].piece.hyperplane;
    const auto corner = [&](std::uint32_t c) { return facet.faces_plus ? c : (3 - c) % 3; };
    const std::uint32_t begin = f.corner, end = (f.corner + 1U) % 3;
    const std::uint32_t side = facet.faces_plus ? f.corner : 2U - f.corner;
    Wedge w{{f.triangle, g.triangle},
            {plane, plane == other ? facet.piece.walls[side] : other},
            {triangles_[f.triangle][begin], triangles_[f.triangle][end]},
            {facet.piece.corners[corner(begin)], facet.piece.corners[corner(end)]},
            orientation(f, g) == Turn::more};
    return w;
  }

  const HyperplaneTable<3>& table_;
  std::span<const bsp::Facet<3>> facets_;
  ExactMeshView mesh_;
  std::vector<bool> is_given_;
  std::vector<Triangle> triangles_;  ///< with one number for equal vertices
};

}  // namespace

std::vector<Wedge> wedges_of(const HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets,
                             ExactMeshView mesh) {
  return WedgeFinder(table, facets, mesh).all();
}

}  // namespace strata::convex
