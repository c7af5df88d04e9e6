#include "oracle/hull.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "strata/convex.h"
#include "strata/measure.h"
#include "support/random.h"

namespace strata::oracle {
namespace {

/// Lattice points, doubles of one size, doubles of mixed size, and points of a few slanted planes.
std::vector<Vertex> awkward_points(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Vertex> points;
  const int count = random.between(1, 40), kind = static_cast<int>(seed % 4), size = random.between(1, 3);
  while (static_cast<int>(points.size()) < count) {
    Vertex p;
    for (double& x : p) {
      x = kind == 0 ? random.between(-size, size) : kind == 1 ? random.unit() : random.between(-size, size) / 10.0;
      if (kind == 2) x = std::ldexp(x, random.between(-40, 40));
    }
    if (kind == 3) p[2] = random.once_in(3) ? p[2] : p[0] / 3 + p[1] / 7 + random.between(0, 1);
    points.push_back(p);
  }
  return points;
}

std::set<Vertex> as_set(std::vector<Vertex> vertices) {
  for (Vertex& v : vertices)
    for (double& x : v) x += 0.0;
  return {vertices.begin(), vertices.end()};
}

}  // namespace

// Catches: a wrong sign anywhere in the hull. CGAL may leave points inside facets and edges; the hull is the same.
TEST_CASE("hulls are CGAL's", "[oracle][convex]") {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    const std::vector<Vertex> points = awkward_points(seed);
    const convex::Polytope ours = convex::convex_hull(points);
    const Hull theirs = oracle::convex_hull(points);
    REQUIRE(convex::violations(ours).empty());
    REQUIRE(ours.dimension == theirs.dimension);
    const std::set<Vertex> mine = as_set(ours.vertices), others = as_set(theirs.mesh.vertices);
    REQUIRE(std::includes(others.begin(), others.end(), mine.begin(), mine.end()));
    if (ours.dimension == 3) REQUIRE(volume(convex::mesh_of(ours)) == volume(ExactMesh{theirs.mesh, {}}));
  }
}

}  // namespace strata::oracle
