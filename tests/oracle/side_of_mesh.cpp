#include "oracle/side_of_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace strata::oracle {

std::vector<int> sides_of_mesh(const Mesh& mesh, std::span<const Vertex> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  for (const auto& [x, y, z] : mesh.vertices) surface.add_vertex({x, y, z});
  using Index = Surface::Vertex_index;
  for (const auto& [a, b, c] : mesh.triangles)
    if (surface.add_face(Index(a), Index(b), Index(c)) == Surface::null_face())
      throw std::invalid_argument("CGAL refuses a face: the mesh is not manifold");
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(surface);
  std::vector<int> sides;
  for (const auto& [x, y, z] : points) {
    const CGAL::Bounded_side s = side({x, y, z});
    sides.push_back(s == CGAL::ON_BOUNDED_SIDE ? 1 : s == CGAL::ON_BOUNDARY ? 0 : -1);
  }
  return sides;
}

}  // namespace strata::oracle
