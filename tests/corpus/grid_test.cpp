#include <catch2/catch.hpp>
#include <vector>

#include "strata/measure.h"
#include "strata/solid.h"
#include "support/shapes.h"

namespace strata::test {
namespace {

/// Unit cubes of an n * n * n grid, all or those of one colour.
std::vector<Solid> cubes(int n, bool checkerboard) {
  std::vector<Solid> all;
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        if (checkerboard && (i + j + k) % 2 != 0) continue;
        const Vertex lower{double(i), double(j), double(k)};
        all.emplace_back(box(lower, {lower[0] + 1, lower[1] + 1, lower[2] + 1}));
      }
    }
  }
  return all;
}

CellGrid checkered(int n) {
  CellGrid grid(n, n, n, false);
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) grid.filled[grid.number(i, j, k)] = (i + j + k) % 2 == 0;
    }
  }
  return grid;
}

}  // namespace

// Catches: internal walls, and vertices of many operands at one point that are not the same vertex.
TEST_CASE("a thousand touching unit cubes unite into one box", "[corpus][grid]") {
  const Solid result = union_(cubes(10, false));
  CHECK(result.volume() == 1000);
  CHECK(result.area() == Approx(600).epsilon(1e-12));
  const CanonicalForm form = result.canonical();
  CHECK(form.vertices.size() == 8);
  CHECK(form.facet_count() == 6);
  CHECK(form == Solid(box({0, 0, 0}, {10, 10, 10})).canonical());
}

TEST_CASE("the checkerboard of a thousand cells keeps every face and shares every edge", "[corpus][grid]") {
  const Solid result = union_(cubes(10, true));
  CHECK(result.volume() == 500);
  CHECK(result.area() == Approx(3000).epsilon(1e-12));
  const Solid expected(cell_solid(checkered(10)));
  CHECK(result.canonical() == expected.canonical());
  const Topology found = topology(result.exact_mesh());
  CHECK(found.components == 1);
  CHECK(found.non_manifold_edges == topology(expected.exact_mesh()).non_manifold_edges);
}

TEST_CASE("the symmetric difference of touching cubes is their union", "[corpus][grid]") {
  CHECK(symmetric_difference(cubes(4, false)).canonical() == Solid(box({0, 0, 0}, {4, 4, 4})).canonical());
}

}  // namespace strata::test
