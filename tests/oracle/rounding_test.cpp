// Rounded solids: do their triangles cross? CGAL answers.
#include "strata/rounding.h"

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "oracle/comparison.h"
#include "oracle/embedding.h"
#include "strata/primitives.h"
#include "strata/solid.h"
#include "support/random.h"
#include "support/shapes.h"

namespace strata::oracle {
namespace {

std::vector<CoordinateGrid> grids() {
  std::vector<CoordinateGrid> list{{}, {CoordinateGrid::Format::float32, 0}};
  for (const Rational& step : {Rational(1, 1000), Rational(1, 50), Rational(1, 8)})
    list.push_back({CoordinateGrid::Format::float64, step});
  return list;
}

}  // namespace

TEST_CASE("rounded solids do not cross themselves", "[oracle][rounding]") {
  const auto [first, last] = seeds({0, 60});
  for (std::uint64_t seed = first; seed < last; ++seed) {
    test::Random random(seed);
    Solid solid;
    for (int n = 0; n < 6; ++n) {
      std::array<Vertex, 6> points;
      for (Vertex& p : points)
        for (double& x : p) x = 2 * random.unit() - 1;
      const Solid next(test::convex_hull(points));
      solid = n % 3 == 2 ? solid - next : solid | next;
    }
    for (const CoordinateGrid& grid : grids()) {
      INFO("seed " << seed << ", step " << to_nearest_double(grid.step));
      CHECK(is_embedded(round_to_solid(solid.exact_mesh(), grid).mesh));
    }
  }
}

TEST_CASE("rounded unions of spheres whose circles of latitude are parallel", "[oracle][rounding]") {
  const auto [first, last] = seeds({0, 4});
  for (std::uint64_t seed = first; seed < last; ++seed) {
    test::Random random(seed);
    Solid all;
    for (int n = 0; n < 12; ++n) {
      Mesh sphere = make_sphere(1, 40).mesh();
      const Vertex middle{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
      for (Vertex& v : sphere.vertices) v = {v[0] + middle[0], v[1] + middle[1], v[2] + middle[2]};
      all = all | Solid(sphere);
    }
    for (const CoordinateGrid& grid : grids()) {
      INFO("seed " << seed << ", step " << to_nearest_double(grid.step));
      const RoundedMesh rounded = round_to_solid(all.exact_mesh(), grid);
      CHECK(is_embedded(rounded.mesh));
      CHECK(rounded.report.rounds < 20);
    }
  }
}

TEST_CASE("the judge of embeddings finds crossings", "[oracle][rounding]") {
  Mesh cube = test::box({0, 0, 0}, {1, 1, 1});
  CHECK(is_embedded(cube));
  cube.vertices[0] = {0.5, 0.5, 2};
  CHECK_FALSE(is_embedded(cube));
}

}  // namespace strata::oracle
