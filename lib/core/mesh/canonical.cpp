#include <algorithm>
#include <limits>
#include <utility>

#include "core/exact/pace.h"
#include "core/mesh/planar_chain.h"
#include "core/mesh/planar_facets.h"
#include "core/mesh/planar_levels.h"
#include "core/mesh/planar_loops.h"
#include "strata/measure.h"

namespace strata {
namespace {

using namespace facets;

/// Keeps two axes, such that a plane's normal, whose first nonzero coefficient is positive, points towards the viewer.
Projection projection_of(const Coefficients& plane) {
  int dropped = 0;
  while (plane[dropped] == 0) ++dropped;
  return {(dropped + 1) % 3, (dropped + 2) % 3};
}

Region single_region(const Chain& chain, Facing facing) {
  Region region{facing, 1, {}};
  for (const NetEdge& e : chain) region.sides.push_back(e.count > 0 ? Side{e.low, e.high} : Side{e.high, e.low});
  return region;
}

bool is_one_triangle(const PointTable& points, Projection axes, const Chain& chain) {
  return chain.size() == 3 && chain[0].low == chain[1].low &&
         orientation(points, axes, chain[0].low, chain[0].high, chain[1].high) != 0;
}

/// The regions that the facets of one plane cover. Facets of one orientation do not overlap in the boundary of a solid.
/// Facets of opposite orientations may overlap; the common part cancels.
std::vector<Region> regions_in_plane(PointTable& points, Projection axes, const PlaneFacets& facets) {
  Chain chain = net_chain(points, facets.sides);
  const bool mixed = facets.has_front && facets.has_back;
  const Facing facing = facets.has_front ? Facing::front : Facing::back;
  if (chain.empty()) return {};
  if (!mixed && is_one_triangle(points, axes, chain)) return {single_region(chain, facing)};
  chain = cut_at_contacts(points, axes, chain);
  const auto is_multiple = [](const NetEdge& e) { return e.count > 1 || e.count < -1; };
  if (mixed || std::any_of(chain.begin(), chain.end(), is_multiple)) {
    chain = cut_at_crossings(points, axes, chain);
    return covered_regions(points, axes, chain);
  }
  if (chain.empty()) return {};
  return {single_region(chain, facing)};
}

/// Adds the boundary loops of one plane, for each orientation, to the form. Vertices are still names in the table.
/// Takes what the facets have: there may be millions of planes.
void add_facets(PointTable& points, PlaneFacets facets, CanonicalForm& form) {
  const Projection axes = projection_of(facets.plane);
  std::vector<std::vector<std::uint32_t>> fronts, backs;
  for (const Region& region : regions_in_plane(points, axes, facets)) {
    auto& list = region.facing == Facing::back ? backs : fronts;
    for (Loop& loop : boundary_loops(points, axes, region)) list.push_back(std::move(loop));
  }
  if (!fronts.empty())
    form.planes.push_back({{backs.empty() ? std::move(facets.plane) : facets.plane}, std::move(fronts)});
  if (backs.empty()) return;
  for (Integer& c : facets.plane) c = -c;
  form.planes.push_back({{std::move(facets.plane)}, std::move(backs)});
}

/// Numbers the points of the loops in lexicographic order, and stores them as the vertices of the form.
void number_vertices(const PointTable& points, CanonicalForm& form, const Monitor& monitor) {
  std::vector<bool> is_used(points.size(), false);
  Pace pace(monitor);
  for (const CanonicalFacets& facets : form.planes) {
    pace.step();
    for (const auto& loop : facets.loops)
      for (const std::uint32_t v : loop) is_used[v] = true;
  }
  std::vector<std::uint32_t> used;
  for (std::uint32_t v = 0; v < is_used.size(); ++v)
    if (is_used[v]) used.push_back(v);
  if (points.has_added()) {
    std::sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) {
      pace.step();
      return points.compare(a, b) < 0;
    });
  }
  std::vector<std::uint32_t> number(points.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::size_t i = 0; i < used.size(); ++i) {
    monitor.check();
    if (i == 0 || points.compare(used[i - 1], used[i]) != 0) form.vertices.push_back(rational(points[used[i]]));
    number[used[i]] = static_cast<std::uint32_t>(form.vertices.size() - 1);
  }
  for (CanonicalFacets& facets : form.planes) {
    for (auto& loop : facets.loops) {
      for (std::uint32_t& v : loop) v = number[v];
    }
  }
}

/// Rotates a loop to its lexicographically smallest form: it starts at its smallest vertex.
void rotate_to_smallest(std::vector<std::uint32_t>& loop) {
  const std::uint32_t smallest = *std::min_element(loop.begin(), loop.end());
  std::vector<std::uint32_t> best;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] != smallest) continue;
    std::vector<std::uint32_t> rotated(loop.begin() + i, loop.end());
    rotated.insert(rotated.end(), loop.begin(), loop.begin() + i);
    if (best.empty() || rotated < best) best = std::move(rotated);
  }
  loop = std::move(best);
}

CanonicalForm form_of(FacetsByPlane facets, const Monitor& monitor) {
  CanonicalForm form;
  for (PlaneFacets& plane : facets.planes) {
    monitor.check();
    add_facets(facets.points, std::move(plane), form);
  }
  number_vertices(facets.points, form, monitor);
  Pace pace(monitor);
  for (CanonicalFacets& plane : form.planes) {
    pace.step();
    for (auto& loop : plane.loops) rotate_to_smallest(loop);
    std::sort(plane.loops.begin(), plane.loops.end());
  }
  std::sort(form.planes.begin(), form.planes.end(), [&](const CanonicalFacets& a, const CanonicalFacets& b) {
    pace.step();
    return a.plane.coefficients < b.plane.coefficients;
  });
  return form;
}

}  // namespace

CanonicalForm canonical_form(const ExactMesh& mesh, const Monitor& monitor) {
  return form_of(facets::facets_by_plane(mesh, monitor), monitor);
}

CanonicalForm canonical_form(const std::vector<ExactFacet>& facets, const Monitor& monitor) {
  std::vector<RationalPoint> points;
  IndexedFacets indexed;
  for (const ExactFacet& facet : facets) {
    monitor.check();
    for (const auto& loop : facet) {
      for (const RationalPoint& p : loop) {
        indexed.corners.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(p);
      }
      indexed.loop_ends.push_back(static_cast<std::uint32_t>(points.size()));
    }
    indexed.facet_loops.push_back(static_cast<std::uint32_t>(facet.size()));
  }
  indexed.points = points;
  return facets::canonical_form(indexed, monitor);
}

CanonicalForm facets::canonical_form(const IndexedFacets& facets, const Monitor& monitor) {
  return form_of(facets_by_plane(facets, monitor), monitor);
}

}  // namespace strata
