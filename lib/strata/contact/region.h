#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "strata/contact/parts.h"
#include "strata/exact/rational.h"
#include "strata/mesh/canonical.h"

namespace strata::contact {

/// A connected piece of a plane in which two solids touch, with the outward side of the first one.
struct ContactFacet {
  CanonicalPlane plane;
  /// Corners by numbers of ContactRegion::points: first the outer polygon, then holes, the facet on the left as seen
  /// from outside of the first solid. No corner lies inside a straight side.
  std::vector<std::vector<std::uint32_t>> loops;
  RationalPoint area_vector;  ///< exact: the normal as long as the area
  Rational squared_area;      ///< exact: the square of its length
  double area = 0;            ///< within an ulp
};

/// A segment in which two solids touch and that bounds no facet of their contact.
struct ContactEdge {
  std::array<std::uint32_t, 2> ends{};  ///< numbers of ContactRegion::points, the lower one first
  Rational squared_length;              ///< exact
  double length = 0;                    ///< within an ulp
};

/// A.b n B.b for two closed regular solids A and B whose interiors do not meet: the closed, non-regularized set in
/// which they touch. Each dimension holds what no higher one has: facets are maximal; edges are maximal segments of
/// what is left without the closures of facets; vertices are what is left of both.
///
/// A canonical form of the point set: it does not depend on how the solids are triangulated; the order of the solids
/// matters for the sides of facets only.
struct ContactRegion {
  std::vector<RationalPoint> points;  ///< exact, in lexicographic order
  std::vector<ContactFacet> facets;
  std::vector<ContactEdge> edges;
  std::vector<std::uint32_t> vertices;  ///< numbers of points

  [[nodiscard]] bool is_empty() const { return points.empty(); }
  /// Sums in doubles: within a relative (n + 1) 2^-52 for n facets or edges.
  [[nodiscard]] double area() const;
  [[nodiscard]] double length() const;
};

/// The contact region of two parts, in coordinates of the model. Requires that their interiors do not meet. O(k log k)
/// for k pairs of faces that meet, in rationals, and pairs of what is left of edges and points with what is near them.
[[nodiscard]] ContactRegion region_of(const Parts& parts, std::uint32_t a, std::uint32_t b);

}  // namespace strata::contact
