#include "extensions/bsp/triangle_facets.h"

#include <array>
#include <utility>

namespace strata::bsp {
namespace {

/// The walls are planes parallel to the axis nearest to the normal, so a wall meets the triangle's plane in the edge's
/// line, whatever lies beyond the edge.
Facet<3> facet(MeshPlanes& planes, Triangle t, MeshPlanes::Plane plane) {
  if (plane.is_reversed) std::swap(t[1], t[2]);
  const HyperplaneTable<3>& table = planes.table();
  const auto axis = static_cast<int>(table[plane.number].longest_axis());
  Piece<3> piece;
  piece.hyperplane = plane.number;
  for (std::size_t i = 0; i < 3; ++i) piece.walls.push_back(planes.along_axis(t[i], t[(i + 1) % 3], axis));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<std::uint32_t, 3> names{piece.hyperplane, piece.walls[(i + 2) % 3], piece.walls[i]};
    piece.corners.push_back(planes.is_given(t[i]) ? HyperplaneTable<3>::given(names, planes.mesh().mesh.vertices[t[i]])
                                                  : table.meet(names));
  }
  return {std::move(piece), !plane.is_reversed};
}

}  // namespace

std::vector<Facet<3>> triangle_facets(MeshPlanes& planes, const Monitor& monitor) {
  std::vector<Facet<3>> facets;
  facets.reserve(planes.mesh().mesh.triangles.size());
  for (const Triangle& t : planes.mesh().mesh.triangles) {
    monitor.check();
    if (const auto plane = planes.through(t)) facets.push_back(facet(planes, t, *plane));
  }
  return facets;
}

std::vector<Facet<3>> triangle_facets(HyperplaneTable<3>& table, ExactMeshView mesh, const Monitor& monitor) {
  MeshPlanes planes(table, mesh);
  return triangle_facets(planes, monitor);
}

}  // namespace strata::bsp
