#include "extensions/contact/region.h"

#include <algorithm>

#include "core/kernel/filters.h"
#include "extensions/contact/contact_edges.h"
#include "extensions/contact/contact_facets.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

std::uint32_t number_of(const std::vector<RationalPoint>& sorted, const RationalPoint& p) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), p) - sorted.begin());
}

ContactEdge edge_between(const std::vector<RationalPoint>& points, const RationalSegment& ends) {
  const RationalPoint along = ends[1] - ends[0];
  const Rational squared = dot<Rational>(along, along);
  return {{number_of(points, ends[0]), number_of(points, ends[1])}, squared, root(squared)};
}

}  // namespace

double ContactRegion::area() const {
  double sum = 0;
  for (const ContactFacet& f : facets) sum += f.area;
  return sum;
}

double ContactRegion::length() const {
  double sum = 0;
  for (const ContactEdge& e : edges) sum += e.length;
  return sum;
}

ContactRegion region_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor) {
  if (parts.common_box(a, b).empty()) return {};
  const SharedPieces pieces = shared_pieces(parts, a, b, monitor);
  ContactFacets faces = contact_facets(pieces, monitor);
  const std::vector<RationalSegment> edges = contact_edges(pieces, monitor);
  const std::vector<RationalPoint> isolated = isolated_points(pieces, edges, monitor);

  ContactRegion region;
  region.points = faces.points;
  for (const RationalSegment& e : edges) region.points.insert(region.points.end(), e.begin(), e.end());
  region.points.insert(region.points.end(), isolated.begin(), isolated.end());
  std::sort(region.points.begin(), region.points.end());
  region.points.erase(std::unique(region.points.begin(), region.points.end()), region.points.end());
  for (ContactFacet& f : faces.facets)
    for (auto& loop : f.loops)
      for (std::uint32_t& v : loop) v = number_of(region.points, faces.points[v]);
  region.facets = std::move(faces.facets);
  for (const RationalSegment& e : edges) region.edges.push_back(edge_between(region.points, e));
  for (const RationalPoint& p : isolated) region.vertices.push_back(number_of(region.points, p));
  return region;
}

}  // namespace strata::contact
