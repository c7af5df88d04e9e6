#include <catch2/catch.hpp>

#include "contact/parts.h"
#include "support/touching.h"

namespace strata::contact {
namespace {

using namespace test_parts;

/// Twice the area of a triangle in a plane z = const, counter-clockwise positive.
Rational twice_area(const ContactRegion& region, const Triangle& t) {
  const RationalPoint &a = region.points[t[0]], &b = region.points[t[1]], &c = region.points[t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Catches: holes of facets filled, triangles turned, facets mixed up.
TEST_CASE("facets with holes and several facets are divided into triangles", "[contact]") {
  const Solid ring(test::box_with_hole());  // [0, 3]^2 x [0, 1], the middle cell is missing
  const std::array<Solid, 2> parts{ring, box({0, 0, 1}, {3, 3, 2})};
  const ContactRegion region = Assembly(parts).contact_region(0, 1);
  const FacetTriangles found = triangles_of(region);
  REQUIRE(found.facet_of.size() == found.triangles.size());
  Rational sum = 0;
  for (std::size_t t = 0; t < found.triangles.size(); ++t) {
    REQUIRE(found.facet_of[t] < region.facets.size());
    const Rational twice = twice_area(region, found.triangles[t]);
    CHECK(twice > 0);
    sum += twice;
  }
  CHECK(sum == 2 * 8);
  CHECK(triangles_of(ContactRegion()).triangles.empty());
}

}  // namespace
}  // namespace strata::contact
