#include <catch2/catch.hpp>
#include <stdexcept>

#include "strata/bsp.h"
#include "support/shapes.h"

namespace strata::bsp {
namespace {

/// Six times the volume of a polytope by its facets, which are counter-clockwise as seen from outside.
Rational six_volumes(const std::vector<BoundaryFacet<3>>& facets) {
  Rational sum = 0;
  for (const BoundaryFacet<3>& f : facets)
    for (std::size_t i = 2; i < f.corners.size(); ++i) {
      const auto &a = f.corners[0], &b = f.corners[i - 1], &c = f.corners[i];
      sum +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  return sum;
}

// Catches: facets that look into the cell, cells left out.
TEST_CASE("bounded cells fill the region", "[bsp]") {
  const Mesh ring = test::box_with_hole();
  const Partition<3> region = partition_of(ExactMesh{ring, {}});
  Rational sum = 0;
  std::size_t cells = 0;
  for_each_bounded_cell<3>(region, [&](const std::vector<BoundaryFacet<3>>& facets) {
    CHECK(six_volumes(facets) > 0);
    sum += six_volumes(facets);
    ++cells;
  });
  CHECK(cells == size_of_tree(region).inside);
  CHECK(sum == 6 * *size(region));
}

TEST_CASE("cells without end are refused", "[bsp]") {
  const auto half = Partition<3>::half_space({0, 0, 1, 0});
  CHECK_THROWS_AS(for_each_bounded_cell<3>(half, [](const auto&) {}), std::domain_error);
}

}  // namespace
}  // namespace strata::bsp
