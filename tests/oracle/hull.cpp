#include "oracle/hull.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <map>
#include <stdexcept>
#include <vector>

namespace strata::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

/// Points are given doubles, so that nothing is rounded.
Vertex to_vertex(const Kernel::Point_3& p) {
  return {CGAL::to_double(p.x().exact()), CGAL::to_double(p.y().exact()), CGAL::to_double(p.z().exact())};
}

Hull to_hull(const Polyhedron& polyhedron) {
  Hull hull{polyhedron.is_closed() ? 3 : 2, {}};
  std::map<Polyhedron::Vertex_const_handle, std::uint32_t> number;
  for (auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v) {
    number.emplace(v, static_cast<std::uint32_t>(hull.mesh.vertices.size()));
    hull.mesh.vertices.push_back(to_vertex(v->point()));
  }
  if (hull.dimension < 3) return hull;
  for (auto f = polyhedron.facets_begin(); f != polyhedron.facets_end(); ++f) {
    const auto first = f->halfedge();
    for (auto h = first->next(); h->next() != first; h = h->next())
      hull.mesh.triangles.push_back(
          {number.at(first->vertex()), number.at(h->vertex()), number.at(h->next()->vertex())});
  }
  return hull;
}

}  // namespace

Hull convex_hull(std::span<const Vertex> points) {
  std::vector<Kernel::Point_3> input;
  for (const auto& [x, y, z] : points) input.emplace_back(x, y, z);
  CGAL::Object object;
  CGAL::convex_hull_3(input.begin(), input.end(), object);
  if (const auto* p = CGAL::object_cast<Kernel::Point_3>(&object)) return {0, {{to_vertex(*p)}, {}}};
  if (const auto* s = CGAL::object_cast<Kernel::Segment_3>(&object))
    return {1, {{to_vertex(s->source()), to_vertex(s->target())}, {}}};
  if (const auto* t = CGAL::object_cast<Kernel::Triangle_3>(&object))
    return {2, {{to_vertex(t->vertex(0)), to_vertex(t->vertex(1)), to_vertex(t->vertex(2))}, {}}};
  if (const auto* polyhedron = CGAL::object_cast<Polyhedron>(&object)) return to_hull(*polyhedron);
  throw std::logic_error("CGAL has a hull of another kind");
}

}  // namespace strata::oracle
