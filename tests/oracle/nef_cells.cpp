#include "oracle/nef_cells.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <algorithm>
#include <deque>
#include <map>

#include "oracle/nef_parts.h"

namespace strata::oracle {
namespace {

using Point = ExactKernel::Point_3;
using Polyhedron = CGAL::Polyhedron_3<ExactKernel>;

Point point(const Vertex& p) { return {p[0], p[1], p[2]}; }

class SurfaceBuilder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit SurfaceBuilder(const PolygonSurface& surface) : surface_(surface) {}

  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, false);
    builder.begin_surface(surface_.points.size(), surface_.polygons.size());
    for (const Vertex& p : surface_.points) builder.add_vertex(point(p));
    for (const auto& polygon : surface_.polygons) builder.add_facet(polygon.begin(), polygon.end());
    builder.remove_unconnected_vertices();
    builder.end_surface();
  }

 private:
  const PolygonSurface& surface_;
};

/// The points in the polygons of a surface: of a closed one, what bounds the polyhedron.
Nef from_surface(const PolygonSurface& surface) {
  Polyhedron polyhedron;
  SurfaceBuilder builder(surface);
  polyhedron.delegate(builder);
  if (polyhedron.size_of_facets() != surface.polygons.size()) throw OracleFailed("a surface is no polyhedron");
  return Nef(polyhedron).boundary();
}

Nef from_polygon(const PolygonSurface& surface, const std::vector<std::uint32_t>& polygon) {
  std::vector<Point> cycle;
  for (const std::uint32_t v : polygon) cycle.push_back(point(surface.points[v]));
  Nef nef(cycle.begin(), cycle.end());
  if (nef.number_of_vertices() != cycle.size()) throw OracleFailed("a polygon is no cycle of vertices");
  return nef;
}

/// Neighbours in the list are joined first, so that operands stay small.
Nef united(std::deque<Nef> queue) {
  if (queue.empty()) return Nef(Nef::EMPTY);
  while (queue.size() > 1) {
    queue.push_back(queue[0] + queue[1]);
    queue.pop_front();
    queue.pop_front();
  }
  return queue.front();
}

Nef united(std::span<const PolygonSurface> surfaces, UnionWay way) {
  std::deque<Nef> parts;
  for (const PolygonSurface& surface : surfaces) {
    if (way != UnionWay::polygons) {
      parts.push_back(from_surface(surface));
      continue;
    }
    for (const auto& polygon : surface.polygons) parts.push_back(from_polygon(surface, polygon));
  }
  if (way == UnionWay::backwards) std::reverse(parts.begin(), parts.end());
  return united(std::move(parts));
}

NefCells cells_of_complement(const Nef& nef) {
  NefCells cells;
  std::map<const Nef::Volume*, std::uint32_t> number;
  for (auto c = nef.volumes_begin(); c != nef.volumes_end(); ++c) {
    if (c->mark()) throw OracleFailed("a cell is part of the surfaces");
    number.emplace(&*c, cells.count++);
  }
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (&*f > &*f->twin()) continue;
    if (!f->mark()) throw OracleFailed("a facet is no part of the surfaces");
    cells.facets.push_back({facet_of(f), number.at(&*f->incident_volume()), number.at(&*f->twin()->incident_volume())});
  }
  return cells;
}

}  // namespace

NefCells nef_cells(std::span<const PolygonSurface> surfaces, UnionWay way) {
  return guarded([&] { return cells_of_complement(united(surfaces, way)); });
}

}  // namespace strata::oracle
