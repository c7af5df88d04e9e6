#include "extensions/contact/contact_facets.h"

#include <algorithm>
#include <utility>

#include "core/exact/failure.h"
#include "core/kernel/filters.h"
#include "core/mesh/planar_facets.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

using Loop = std::vector<std::uint32_t>;

/// The loops of one plane, grouped into facets.
class Nesting {
 public:
  Nesting(const std::vector<RationalPoint>& points, CanonicalFacets& plane) : points_(points), plane_(plane) {
    while (plane.plane.coefficients[axis_] == 0) ++axis_;
    for (Loop& loop : plane.loops) (height(area_vector(loop)) > 0 ? outer_ : holes_).push_back(&loop);
  }

  /// Takes the loops of the plane, and the plane for the last facet: there may be millions of both.
  void add_facets(std::vector<ContactFacet>& facets, const Monitor& monitor) {
    std::vector<std::vector<Loop*>> holes_of(outer_.size());
    for (Loop* const hole : holes_) {
      monitor.check();
      holes_of[around(*hole)].push_back(hole);
    }
    for (std::size_t n = 0; n < outer_.size(); ++n) {
      monitor.check();
      ContactFacet& facet = facets.emplace_back();
      facet.plane = n + 1 == outer_.size() ? std::move(plane_.plane) : plane_.plane;
      facet.loops.reserve(1 + holes_of[n].size());
      facet.loops.push_back(std::move(*outer_[n]));
      for (Loop* const hole : holes_of[n]) facet.loops.push_back(std::move(*hole));
      for (const Loop& loop : facet.loops) {
        const RationalPoint v = area_vector(loop);
        for (std::size_t i = 0; i < 3; ++i) facet.area_vector[i] += v[i];
      }
      facet.squared_area = dot<Rational>(facet.area_vector, facet.area_vector);
      facet.area = root(facet.squared_area);
    }
  }

 private:
  [[nodiscard]] RationalPoint area_vector(const Loop& loop) const {
    RationalPoint sum;
    const RationalPoint& first = points_[loop[0]];
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const RationalPoint v = cross<Rational>(points_[loop[k]] - first, points_[loop[k + 1]] - first);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += v[i] / 2;
    }
    return sum;
  }
  /// The coordinate along the outward normal, in units of one coordinate axis.
  [[nodiscard]] Rational height(const RationalPoint& v) const {
    return plane_.plane.coefficients[axis_] > 0 ? v[axis_] : Rational(-v[axis_]);
  }

  /// The smallest outer loop around a hole. The middle of a hole's side is on no other loop.
  [[nodiscard]] std::size_t around(const Loop& hole) const {
    RationalPoint middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = (points_[hole[0]][i] + points_[hole[1]][i]) / 2;
    std::size_t best = outer_.size();
    Rational best_area;
    for (std::size_t n = 0; n < outer_.size(); ++n) {
      if (!has_inside(*outer_[n], middle)) continue;
      const Rational area = height(area_vector(*outer_[n]));
      if (best == outer_.size() || area < best_area) {
        best = n;
        best_area = area;
      }
    }
    if (best == outer_.size()) throw LogicError("a hole of a contact is in no facet");
    return best;
  }
  /// Decided by the parity of the sides that a ray crosses.
  [[nodiscard]] bool has_inside(const Loop& loop, const RationalPoint& p) const {
    const std::size_t u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const RationalPoint &a = points_[loop[k]], &b = points_[loop[(k + 1) % loop.size()]];
      if ((a[v] > p[v]) == (b[v] > p[v])) continue;
      const Rational orientation = (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]);
      if ((orientation.sign() > 0) == (b[v] > a[v])) inside = !inside;
    }
    return inside;
  }

  const std::vector<RationalPoint>& points_;
  CanonicalFacets& plane_;
  std::size_t axis_ = 0;
  std::vector<Loop*> outer_, holes_;
};

}  // namespace

CanonicalForm form_of(const SharedPieces& pieces, const Monitor& monitor) {
  facets::IndexedFacets polygons;
  polygons.points = pieces.places.positions();
  for (const auto& polygon : pieces.polygons) {
    polygons.corners.insert(polygons.corners.end(), polygon.begin(), polygon.end());
    polygons.loop_ends.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  polygons.facet_loops.assign(pieces.polygons.size(), 1);
  return facets::canonical_form(polygons, monitor);
}

ContactFacets contact_facets(CanonicalForm form, const Monitor& monitor) {
  ContactFacets result;
  for (CanonicalFacets& plane : form.planes) Nesting(form.vertices, plane).add_facets(result.facets, monitor);
  result.points = std::move(form.vertices);
  return result;
}

}  // namespace strata::contact
