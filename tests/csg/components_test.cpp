#include <algorithm>
#include <catch2/catch.hpp>

#include "strata/strata.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::box;

namespace {

Solid unit(double x, double y, double z, double width = 1) {
  return Solid(box({x, y, z}, {x + width, y + width, z + width}));
}

std::vector<Rational> volumes(const std::vector<Solid>& solids) {
  std::vector<Rational> volumes;
  for (const Solid& s : solids) volumes.push_back(s.volume());
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

/// The volumes of the components of filled cells that are connected over squares.
std::vector<Rational> volumes(test::CellGrid grid) {
  std::vector<Rational> volumes;
  const auto flood = [&](const auto& self, int i, int j, int k) -> int {
    if (!grid.at(i, j, k)) return 0;
    grid.filled[grid.number(i, j, k)] = false;
    return 1 + self(self, i - 1, j, k) + self(self, i + 1, j, k) + self(self, i, j - 1, k) + self(self, i, j + 1, k) +
           self(self, i, j, k - 1) + self(self, i, j, k + 1);
  };
  for (int i = 0; i < grid.size[0]; ++i)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int k = 0; k < grid.size[2]; ++k)
        if (const int size = flood(flood, i, j, k); size > 0) volumes.emplace_back(size);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

void check_parts(const Solid& whole, const std::vector<Solid>& parts) {
  CHECK(union_(parts) == whole);
  Rational sum = 0;
  for (const Solid& p : parts) {
    sum += p.volume();
    CHECK(check(p.exact_mesh()).empty());
    CHECK(p.sources().size() == p.mesh().triangles.size());
  }
  CHECK(sum == whole.volume());
}

}  // namespace

TEST_CASE("parts that are apart, or touch in an edge or a vertex only, are components", "[csg]") {
  CHECK(Solid().components().empty());
  CHECK(unit(0, 0, 0).components() == std::vector{unit(0, 0, 0)});
  for (const Solid& other : {unit(3, 0, 0), unit(1, 1, 0), unit(1, 1, 1)}) {
    const Solid both = unit(0, 0, 0) | other;
    const auto parts = both.components();
    REQUIRE(parts.size() == 2);
    CHECK(parts[0] == unit(0, 0, 0));
    CHECK(parts[1] == other);
    check_parts(both, parts);
  }
  CHECK((unit(0, 0, 0) | unit(1, 0, 0)).components().size() == 1);
  CHECK(Solid(test::edge_sharing_cells()).components().size() == 2);
  CHECK(Solid(test::vertex_sharing_cells()).components().size() == 2);
}

// Catches: cavities that become components, or go to the wrong one of the solids around them.
TEST_CASE("cavities belong to the innermost solid around them", "[csg]") {
  const auto shell = [](double outer) {
    return unit(-outer, -outer, -outer, 2 * outer) - unit(-outer + 1, -outer + 1, -outer + 1, 2 * outer - 2);
  };
  const Solid nested = union_({shell(20), shell(15), shell(10), unit(-1, -1, -1, 2), unit(30, 0, 0)});
  const auto parts = nested.components();
  REQUIRE(parts.size() == 5);
  check_parts(nested, parts);
  for (const Solid& part : {shell(20), shell(15), shell(10), unit(-1, -1, -1, 2), unit(30, 0, 0)})
    CHECK(std::find(parts.begin(), parts.end(), part) != parts.end());
}

TEST_CASE("a cavity may touch the boundary around it in a vertex or an edge", "[csg]") {
  const Solid cube = unit(0, 0, 0, 4);
  const Solid by_edge = cube - Solid(test::tetrahedron({1, 0, 2}, {3, 0, 2}, {2, 1, 2}, {2, 1, 3}));
  const Solid by_vertex = cube - Solid(test::octahedron({2, 2, 2}, 2));
  CHECK(by_edge.components().size() == 1);
  CHECK(by_vertex.components().size() == 1);
  // Two solids in one cavity, both of which touch it.
  const Solid full = (cube - unit(1, 1, 1, 2)) | Solid(test::octahedron({2, 2, 2}, 1));
  CHECK(full.components().size() == 2);
  check_parts(full, full.components());
}

TEST_CASE("components of cells are those that are connected over squares", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    test::CellGrid grid(random.between(2, 5), random.between(2, 5), random.between(2, 5), false);
    const std::uint64_t rarity = 1 + random.below(3);
    for (std::size_t i = 0; i < grid.filled.size(); ++i)
      grid.filled[i] = rarity == 1 ? !random.once_in(4) : random.once_in(rarity);
    const Solid solid(test::cell_solid(grid));
    const auto parts = solid.components();
    CHECK(volumes(parts) == volumes(grid));
    if (seed % 10 == 0) check_parts(solid, parts);
    // Exact vertices, in a general position.
    const Solid turned = solid.rotated(Quaternion{3, 1, -2, 5}).translated({Rational(1, 3), 0, Rational(1, 7)});
    CHECK(volumes(turned.components()) == volumes(grid));
  }
}

TEST_CASE("components of results add up", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const auto operands = test::touching_pair(seed);
    const Solid result = Solid(operands.meshes[0]) ^ Solid(operands.meshes[1]);
    const auto parts = result.components();
    check_parts(result, parts);
    for (const Solid& p : parts) CHECK(p.components().size() == 1);
  }
}

TEST_CASE("components keep the order, the vertices and the sources of triangles", "[csg]") {
  const Solid both = unit(5, 0, 0) | unit(0, 0, 0);
  const auto parts = both.components();
  REQUIRE(parts.size() == 2);
  std::size_t t = 0;
  for (const Solid& p : parts)
    for (std::size_t i = 0; i < p.mesh().triangles.size(); ++i, ++t) {
      CHECK(p.sources()[i] == both.sources()[t]);
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(p.mesh().vertices[p.mesh().triangles[i][c]] == both.mesh().vertices[both.mesh().triangles[t][c]]);
    }
}
