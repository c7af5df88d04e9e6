#include "extensions/convex/wedges.h"

#include "core/mesh/across_solid.h"
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

  std::vector<Wedge> all(const Monitor& monitor) {
    const std::vector<std::uint32_t> first = equal_vertices(mesh_, monitor);
    triangles_.assign(mesh_.mesh.triangles.begin(), mesh_.mesh.triangles.end());
    for (Triangle& t : triangles_)
      for (std::uint32_t& v : t) v = first[v];
    const std::vector<EdgeUse> uses = edge_table(triangles_, mesh_.mesh.vertices.size(), monitor);
    const AcrossSolid across_solid(
        [&](const EdgeUse& use, const EdgeUse& other) { return outer_side(use.triangle, apex(other)); });
    std::vector<Wedge> wedges;
    const auto add_wedges = [&](std::span<const EdgeUse> around) {
      for (const EdgeUse& f : around)
        if (f.forward) {
          const EdgeUse& g = across_solid(f, around);
          wedges.push_back(wedge(f, g, across_solid.angle(f, g) == WedgeAngle::more));
        }
    };
    for_each_edge(uses, add_wedges, monitor);
    return wedges;
  }

 private:
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
  [[nodiscard]] Wedge wedge(const EdgeUse& f, const EdgeUse& g, bool is_reflex) const {
    const bsp::Facet<3>& facet = facets_[f.triangle];
    const std::uint32_t plane = facet.piece.hyperplane, other = facets_[g.triangle].piece.hyperplane;
    const auto corner = [&](std::uint32_t c) { return facet.faces_plus ? c : (3 - c) % 3; };
    const std::uint32_t begin = f.corner, end = (f.corner + 1U) % 3;
    const std::uint32_t side = facet.faces_plus ? f.corner : 2U - f.corner;
    Wedge w{{f.triangle, g.triangle},
            {plane, plane == other ? facet.piece.walls[side] : other},
            {triangles_[f.triangle][begin], triangles_[f.triangle][end]},
            {facet.piece.corners[corner(begin)], facet.piece.corners[corner(end)]},
            is_reflex};
    return w;
  }

  const HyperplaneTable<3>& table_;
  std::span<const bsp::Facet<3>> facets_;
  ExactMeshView mesh_;
  std::vector<bool> is_given_;
  std::vector<Triangle> triangles_;  ///< with one number for equal vertices
};

}  // namespace

std::vector<Wedge> wedges_of(const HyperplaneTable<3>& table, std::span<const bsp::Facet<3>> facets, ExactMeshView mesh,
                             const Monitor& monitor) {
  return WedgeFinder(table, facets, mesh).all(monitor);
}

}  // namespace strata::convex
