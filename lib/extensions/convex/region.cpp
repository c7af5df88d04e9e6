#include "extensions/convex/region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/kernel/box.h"
#include "extensions/bsp/triangle_facets.h"
#include "extensions/convex/cut_planes.h"
#include "strata/errors.h"

namespace strata::convex {
namespace {

/// Divides the content of a region. The sides of its faces are recorded in the workspace.
class Splitter {
 public:
  Splitter(const PreparedBoundary& boundary, Workspace& workspace, std::uint32_t plane, RegionSides& sides)
      : boundary_(boundary), workspace_(workspace), plane_(plane), sides_(sides) {}

  void add(const Face& f) {
    bsp::Split<3> parts = bsp::split(boundary_.table, *f.part, plane_);
    workspace_.lies[f.triangle] = parts.lie;
    switch (parts.lie) {
      case bsp::Lie::on:
        sides_.is_minus_inside = boundary_.facets[f.triangle].faces_plus;
        sides_.is_plus_inside = !sides_.is_minus_inside;
        break;
      case bsp::Lie::minus:
        sides_.minus.faces.push_back(f);
        break;
      case bsp::Lie::plus:
        sides_.plus.faces.push_back(f);
        break;
      case bsp::Lie::both:
        sides_.minus.faces.push_back({f.triangle, keep(std::move(parts.minus))});
        sides_.plus.faces.push_back({f.triangle, keep(std::move(parts.plus))});
        break;
    }
  }

  /// Requires that faces are added before edges.
  void add(const Edge& e) {
    const Wedge& w = boundary_.wedges[e.wedge];
    const Sign from = boundary_.table.side(plane_, e.ends[0]), to = boundary_.table.side(plane_, e.ends[1]);
    if (from == Sign::zero && to == Sign::zero) {
      const bsp::Lie lie = workspace_.lies[w.faces[0]];
      if (w.is_reflex || lie != workspace_.lies[w.faces[1]]) return;
      if (lie == bsp::Lie::minus) sides_.minus.edges.push_back(e);
      if (lie == bsp::Lie::plus) sides_.plus.edges.push_back(e);
    } else if (from * to == Sign::negative) {
      const HyperplaneMeet<3> middle = boundary_.table.meet({w.planes[0], w.planes[1], plane_});
      edges_on(from).push_back({e.wedge, {e.ends[0], middle}});
      edges_on(to).push_back({e.wedge, {middle, e.ends[1]}});
    } else {
      edges_on(from == Sign::zero ? to : from).push_back(e);
    }
  }

 private:
  const bsp::Piece<3>* keep(bsp::Piece<3> part) { return &workspace_.parts.emplace_back(std::move(part)); }
  std::vector<Edge>& edges_on(Sign side) { return (side == Sign::negative ? sides_.minus : sides_.plus).edges; }

  const PreparedBoundary& boundary_;
  Workspace& workspace_;
  std::uint32_t plane_;
  RegionSides& sides_;
};

bsp::HalfSpace behind(std::uint32_t plane, bool faces_plus) {
  return {plane, faces_plus ? Sign::negative : Sign::positive};
}

/// A facet of a convex part in a plane of the solid, and the half-spaces of the faces beside it.
struct OwnFacet {
  std::uint32_t plane = 0;
  bool faces_plus = false;
  std::vector<bsp::HalfSpace> by;
};

/// By plane, increasing.
std::vector<OwnFacet> own_facets(const PreparedBoundary& boundary, const Region& region) {
  std::vector<OwnFacet> facets;
  for (const Face& f : region.faces)
    facets.push_back({boundary.plane_of(f.triangle), boundary.facets[f.triangle].faces_plus, {}});
  const auto less = [](const OwnFacet& a, const OwnFacet& b) { return a.plane < b.plane; };
  std::sort(facets.begin(), facets.end(), less);
  facets.erase(std::unique(facets.begin(), facets.end(),
                           [](const OwnFacet& a, const OwnFacet& b) { return a.plane == b.plane; }),
               facets.end());
  const auto add = [&](std::uint32_t of, std::uint32_t by) {
    const bsp::HalfSpace h = behind(boundary.plane_of(by), boundary.facets[by].faces_plus);
    auto& list = std::lower_bound(facets.begin(), facets.end(), OwnFacet{boundary.plane_of(of), false, {}}, less)->by;
    const auto is_known = [&](const bsp::HalfSpace& k) { return k.hyperplane == h.hyperplane; };
    if (std::none_of(list.begin(), list.end(), is_known)) list.push_back(h);
  };
  for (const Edge& e : region.edges) {
    const auto [f, g] = boundary.wedges[e.wedge].faces;
    if (boundary.plane_of(f) == boundary.plane_of(g)) continue;
    add(f, g);
    add(g, f);
  }
  return facets;
}

/// Clips a facet by the plane of another one. A side in that plane gets it as its neighbour, because the part beyond it
/// is cut off. False if nothing is left.
bool clip_facet(const HyperplaneTable<3>& table, bsp::Piece<3>& polygon, const bsp::HalfSpace& h) {
  if (!bsp::clip(table, polygon, h)) return false;
  const std::size_t n = polygon.corners.size();
  const auto is_on = [&](std::size_t i) { return table.side(h.hyperplane, polygon.corners[i]) == Sign::zero; };
  for (std::size_t i = 0; i < n; ++i)
    if (is_on(i) && is_on((i + 1) % n)) polygon.walls[i] = h.hyperplane;
  return true;
}

/// The planes are about as far from the vertices as these are from one another, so that numbers are not much larger,
/// and beyond the rounding errors of vertices.
bsp::BoxPlanes box_about(HyperplaneTable<3>& table, const MeshView& mesh) {
  constexpr double share_of_coordinate = 0x1p-40;
  Box box;
  for (const Vertex& v : mesh.vertices) box.include(v);
  double size = std::numeric_limits<double>::denorm_min();
  for (std::size_t i = 0; i < 3; ++i)
    for (const double x :
         {box.upper[i] / 2 - box.lower[i] / 2, box.lower[i] * share_of_coordinate, box.upper[i] * share_of_coordinate})
      size = std::max(size, std::abs(x));
  int exponent = 0;
  static_cast<void>(std::frexp(size, &exponent));
  const Integer two = 2;
  const Rational margin = exponent > 0 ? Rational(two << exponent) : Rational(two, Integer(1) << -exponent);
  bsp::BoxPlanes planes{};
  for (std::size_t i = 0; i < 3; ++i)
    planes[i] = {table.add(axis_hyperplane<3>(i, to_rational(box.lower[i]) - margin)),
                 table.add(axis_hyperplane<3>(i, to_rational(box.upper[i]) + margin))};
  return planes;
}

}  // namespace

PreparedBoundary::PreparedBoundary(ExactMeshView mesh, const Monitor& monitor) : box(box_about(table, mesh.mesh)) {
  bsp::MeshPlanes planes(table, mesh);
  facets = bsp::triangle_facets(planes, monitor);
  if (facets.size() != mesh.mesh.triangles.size()) throw std::invalid_argument("a triangle of a solid has no area");
  monitor.check();
  wedges = wedges_of(table, facets, mesh, monitor);
  monitor.check();
  cut_planes = convex::cut_planes(planes, facets, wedges, monitor);
}

Workspace::Workspace(const PreparedBoundary& boundary)
    : lies(boundary.facets.size()), parents(boundary.facets.size()), of_planes(boundary.table.size()) {}

Region whole_region(const PreparedBoundary& boundary, CellMaker& maker) {
  Region all{maker.box(), {}, {}};
  for (std::uint32_t t = 0; t < boundary.facets.size(); ++t) all.faces.push_back({t, &boundary.facets[t].piece});
  for (std::uint32_t w = 0; w < boundary.wedges.size(); ++w) all.edges.push_back({w, boundary.wedges[w].ends});
  return all;
}

// A side without faces is outside or inside as a whole. If the region has faces in the plane, these decide. If not, the
// plane contains a reflex edge, at which the outside takes less than 180 degrees, so the side is inside.
RegionSides split(const PreparedBoundary& boundary, CellMaker& maker, Workspace& workspace, const Region& region,
                  std::uint32_t plane) {
  RegionSides sides;
  CellMaker::Halves halves = maker.split(region.cell, plane);
  if (!halves.minus || !halves.plus) throw LogicError("a plane through a region does not divide it");
  sides.minus.cell = std::move(*halves.minus);
  sides.plus.cell = std::move(*halves.plus);
  Splitter splitter(boundary, workspace, plane, sides);
  for (const Face& f : region.faces) splitter.add(f);
  for (const Edge& e : region.edges) splitter.add(e);
  return sides;
}

// The region's own facets are first: only those that are left bound the others.
Cell inside_of(const PreparedBoundary& boundary, CellMaker& maker, const Region& region, const Monitor& monitor) {
  const std::vector<OwnFacet> own = own_facets(boundary, region);
  Cell inside;
  for (const CellFacet& f : region.cell.facets) {
    monitor.check();
    if (maker.is_of_box(f.plane)) continue;
    bsp::Piece<3> polygon = maker.piece_of(f);
    const bool is_left = std::all_of(own.begin(), own.end(), [&](const OwnFacet& facet) {
      return clip_facet(boundary.table, polygon, behind(facet.plane, facet.faces_plus));
    });
    if (is_left) inside.facets.push_back(maker.facet_of(polygon, f.faces_plus));
  }
  std::vector<bsp::HalfSpace> of_region;
  for (const CellFacet& f : inside.facets) of_region.push_back(behind(f.plane, f.faces_plus));
  for (const OwnFacet& facet : own) {
    monitor.check();
    bsp::Piece<3> polygon = maker.whole(facet.plane);
    for (const std::vector<bsp::HalfSpace>* by :
         {&facet.by, static_cast<const std::vector<bsp::HalfSpace>*>(&of_region)})
      for (const bsp::HalfSpace& h : *by)
        if (!bsp::clip(boundary.table, polygon, h)) throw LogicError("a facet of a convex piece has no area");
    inside.facets.push_back(maker.facet_of(polygon, facet.faces_plus));
  }
  return inside;
}

}  // namespace strata::convex
