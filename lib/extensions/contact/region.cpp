#include "extensions/contact/region.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/kernel/filters.h"
#include "extensions/contact/contact_edges.h"
#include "extensions/contact/contact_facets.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

std::uint32_t number_of(const std::vector<RationalPoint>& sorted, const RationalPoint& p) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), p) - sorted.begin());
}

/// The numbers of some points among all, both in lexicographic order.
std::vector<std::uint32_t> numbers_of(const std::vector<RationalPoint>& some, const std::vector<RationalPoint>& all,
                                      const Monitor& monitor) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(some.size());
  std::uint32_t n = 0;
  for (const RationalPoint& p : some) {
    monitor.check();
    while (all[n] != p) ++n;
    numbers.push_back(n);
  }
  return numbers;
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
  std::optional<SharedPieces> pieces(shared_pieces(parts, a, b, monitor));
  const std::vector<RationalSegment> edges = contact_edges(*pieces, monitor);
  const std::vector<RationalPoint> isolated = isolated_points(*pieces, edges, monitor);
  CanonicalForm form = form_of(*pieces, monitor);
  pieces.reset();
  ContactFacets faces = contact_facets(std::move(form), monitor);

  std::vector<RationalPoint> others = isolated;
  for (const RationalSegment& e : edges) others.insert(others.end(), e.begin(), e.end());
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  monitor.check();
  ContactRegion region;
  std::set_union(faces.points.begin(), faces.points.end(), others.begin(), others.end(),
                 std::back_inserter(region.points));
  const std::vector<std::uint32_t> number_of_corner = numbers_of(faces.points, region.points, monitor);
  for (ContactFacet& f : faces.facets)
    for (auto& loop : f.loops)
      for (std::uint32_t& v : loop) v = number_of_corner[v];
  region.facets = std::move(faces.facets);
  for (const RationalSegment& e : edges) region.edges.push_back(edge_between(region.points, e));
  for (const RationalPoint& p : isolated) region.vertices.push_back(number_of(region.points, p));
  return region;
}

}  // namespace strata::contact
