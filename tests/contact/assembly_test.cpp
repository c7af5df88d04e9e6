#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "contact/parts.h"
#include "core/kernel/box.h"
#include "core/kernel/disjoint_sets.h"
#include "strata/contact.h"
#include "support/random.h"
#include "support/touching.h"

namespace strata::contact {
namespace {

using namespace test_parts;

std::vector<Solid> grid(int nx, int ny, int nz, double step) {
  std::vector<Solid> cubes;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k)
        cubes.push_back(box({i * step, j * step, k * step}, {i * step + 1, j * step + 1, k * step + 1}));
  return cubes;
}

TEST_CASE("cubes of a grid touch in as many faces, edges and vertices as they must", "[contact]") {
  for (const auto& [x, y, z] : {std::array{2, 3, 4}, {5, 1, 3}, {1, 1, 6}, {4, 4, 4}}) {
    CAPTURE(x, y, z);
    const std::vector<Solid> cubes = grid(x, y, z, 1);
    const Assembly assembly(cubes);
    std::map<std::vector<std::size_t>, int> seen;
    double area = 0, length = 0;
    for (const RelatedPair& pair : assembly.pairs()) {
      REQUIRE(pair.relation == Relation::contact);
      const ContactRegion r = assembly.contact_region(pair.a, pair.b);
      ++seen[counts(r)];
      area += r.area();
      length += r.length();
    }
    const int a = x - 1, b = y - 1, c = z - 1;
    const int faces = a * y * z + x * b * z + x * y * c;
    const int edges = 2 * (a * b * z + a * y * c + x * b * c);
    const int vertices = 4 * a * b * c;
    CHECK(seen[{1, 0, 0}] == faces);
    CHECK(seen[{0, 1, 0}] == edges);
    CHECK(seen[{0, 0, 1}] == vertices);
    CHECK(area == faces);
    CHECK(length == edges);
  }
}

/// The components of the interior of a random union of cells of a grid: cells that share a face are one.
std::vector<Solid> components_of_random_cells(test::Random& random) {
  constexpr std::uint32_t n = 3;
  std::vector<bool> taken(n * n * n);
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = random.once_in(2);
  DisjointSets<std::uint32_t> sets(n * n * n);
  const std::uint32_t steps[] = {1, n, n * n};
  for (std::uint32_t i = 0; i < taken.size(); ++i)
    for (const std::uint32_t step : steps)
      if (i / step % n + 1 < n && taken[i] && taken[i + step]) sets.unite(i, i + step);
  std::map<std::uint32_t, std::vector<Solid>> cells;
  for (std::uint32_t i = 0; i < taken.size(); ++i) {
    const double x = i % n, y = i / n % n, z = i / n / n;
    if (taken[i]) cells[sets.find(i)].push_back(box({x, y, z}, {x + 1, y + 1, z + 1}));
  }
  std::vector<Solid> components;
  for (const auto& [name, parts] : cells) components.push_back(union_(parts));
  return components;
}

// Two components that had a facet in common would be one.
TEST_CASE("components of one set touch in edges and vertices only", "[contact][property]") {
  std::size_t touching = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Assembly assembly(components_of_random_cells(random));
    for (const RelatedPair& pair : assembly.pairs()) {
      REQUIRE(pair.relation == Relation::contact);
      CHECK(assembly.contact_region(pair.a, pair.b).facets.empty());
      ++touching;
    }
  }
  CHECK(touching > 60);
}

TEST_CASE("cubes of a grid that is too narrow interfere, of a wide one are apart", "[contact]") {
  const auto narrow = Assembly(grid(3, 3, 3, 0.75)).pairs();
  CHECK(narrow.size() == 3 * 18 + 6 * 12 + 4 * 8);
  for (const RelatedPair& pair : narrow) CHECK(pair.relation == Relation::interfering);
  CHECK(Assembly(grid(3, 3, 3, 1.25)).pairs().empty());
}

TEST_CASE("pairs of an assembly are what two parts alone are, for any number of threads", "[contact][property]") {
  std::vector<Solid> parts;
  test::Random random(7);
  for (int n = 0; n < 40; ++n) {
    const Vertex by{double(random.between(0, 9)), double(random.between(0, 9)), double(random.between(0, 9))};
    parts.emplace_back(test::translated(test::lattice_solid(random), by));
  }
  parts.emplace_back();
  const Assembly assembly(parts);
  const auto pairs = assembly.pairs();
  std::vector<RelatedPair> expected;
  for (std::uint32_t a = 0; a < parts.size(); ++a)
    for (std::uint32_t b = a + 1; b < parts.size(); ++b)
      if (const Relation r = relation(parts[a], parts[b]); r != Relation::apart) expected.push_back({a, b, r});
  CHECK(pairs == expected);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  CHECK(Assembly(parts).pairs() == pairs);
}

// Catches: boxes grown too little, by rounding or by half.
TEST_CASE("near pairs hold all pairs within reach", "[contact][property]") {
  for (const double scale : {1.0, 0.1, 1e-300, 1e300, std::numeric_limits<double>::denorm_min()}) {
    CAPTURE(scale);
    std::vector<Solid> parts = grid(3, 2, 2, 3);
    for (Solid& part : parts) {
      ExactMesh scaled = part.exact_mesh();
      for (Vertex& v : scaled.mesh.vertices)
        for (double& x : v) x *= scale;
      part = Solid(scaled.mesh);
    }
    parts.emplace_back();
    const Assembly assembly(parts);
    const auto all = assembly.near_pairs(std::numeric_limits<double>::infinity());
    CHECK(all.size() == 12 * 11 / 2);
    for (const auto& [a, b] : all) {
      const double distance = assembly.nearest(a, b).distance;
      const auto within = assembly.near_pairs(std::nextafter(distance, Box::infinity));
      CHECK(std::find(within.begin(), within.end(), std::pair(a, b)) != within.end());
    }
    if (scale < 1e-300) continue;
    CHECK(assembly.near_pairs(1.99 * scale).empty());
    CHECK(assembly.near_pairs(2.01 * scale).size() == 50);  // beside one another, diagonally, too
  }
  const std::vector<Solid> ulp{box({0, 0, 0}, {1, 1, 1}), box({1 + 0x1p-52, 0, 0}, {2, 1, 1})};
  CHECK(Assembly(ulp).near_pairs(0x1p-52).size() == 1);
}

TEST_CASE("what two parts have in common is a solid", "[contact]") {
  const Assembly two = pair(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {4, 4, 1.5}));
  CHECK(two.overlap(0, 1).volume() == Rational(1) / 2);
  CHECK(pair(box({0, 0, 0}, {1, 1, 1}), box({5, 5, 5}, {6, 6, 6})).overlap(0, 1).is_empty());
}

TEST_CASE("an assembly can be cancelled", "[contact]") {
  CancelToken cancel;
  cancel.cancel();
  CHECK_THROWS_AS(Assembly(grid(2, 2, 2, 1)).pairs(Monitor(&cancel)), Cancelled);
}

}  // namespace
}  // namespace strata::contact
