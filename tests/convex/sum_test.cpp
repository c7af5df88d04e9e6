#include <catch2/catch.hpp>
#include <cmath>

#include "convex/hull_check.h"
#include "extensions/convex/convex_solid.h"
#include "strata/convex.h"
#include "strata/measure.h"
#include "support/shapes.h"
#include "support/transform.h"

namespace strata::convex {
namespace {

using test::Random;

Polytope point(const Vertex& v) { return {0, {v}, {}, {}}; }
Polytope segment(const Vertex& v, const Vertex& w) { return {1, {std::min(v, w), std::max(v, w)}, {}, {}}; }

/// The hull of points in one plane parallel to two axes or in any plane of a lattice: by gift wrapping.
Polytope polygon(std::vector<Vertex> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<RationalPoint> exact;
  for (const Vertex& v : points) exact.push_back({to_rational(v[0]), to_rational(v[1]), to_rational(v[2])});
  if (test::dimension_of(exact) != 2) return {};
  RationalPoint normal{};
  for (std::size_t i = 2; i < exact.size() && test::is_zero(normal); ++i)
    normal = test::cross_product(test::difference(exact[1], exact[0]), test::difference(exact[i], exact[0]));
  std::vector<std::size_t> loop;
  for (std::size_t at = 0; loop.empty() || at != loop.front();) {
    loop.push_back(at);
    std::size_t next = at == 0 ? 1 : 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (i == at || i == next) continue;
      const auto d = test::difference(exact[next], exact[at]), e = test::difference(exact[i], exact[at]);
      const Rational orientation = test::product(normal, test::cross_product(d, e));
      if (orientation < 0 || (orientation == 0 && test::product(e, e) > test::product(d, d))) next = i;
    }
    at = next;
  }
  std::vector<std::size_t> used = loop;
  std::sort(used.begin(), used.end());
  Polytope result{2, {}, {}, {{}}};
  for (const std::size_t i : used) result.vertices.push_back(points[i]);
  for (const std::size_t i : loop)
    result.facets[0].push_back(
        static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), i) - used.begin()));
  return result;
}

Polytope solid(const Mesh& mesh) { return *convex_solid(surface_of(test::exact(mesh))); }

Vertex lattice_point(Random& random, int size) {
  return {static_cast<double>(random.below(size)), static_cast<double>(random.below(size)),
          static_cast<double>(random.below(size))};
}

/// Of any dimension, with many parallel edges and facets.
Polytope random_polytope(Random& random) {
  const int size = random.below(3) == 0 ? 2 : 4;
  const auto next = [&] { return lattice_point(random, size + 1); };
  switch (random.below(6)) {
    case 0:
      return point(next());
    case 1: {
      const Vertex v = next(), w = next();
      return v == w ? point(v) : segment(v, w);
    }
    case 2: {
      std::vector<Vertex> points;
      const auto axis = static_cast<std::size_t>(random.below(3));
      const bool slanted = random.below(2) == 0;
      for (int i = 0; i < 6; ++i) {
        Vertex v = next();
        v[axis] = slanted ? v[(axis + 1) % 3] - v[(axis + 2) % 3] : 1;
        points.push_back(v);
      }
      const Polytope found = polygon(points);
      return found.dimension == 2 ? found : point(points[0]);
    }
    default: {
      std::vector<Vertex> points;
      for (std::uint64_t i = 4 + random.below(6); i > 0; --i) points.push_back(next());
      const Mesh hull = test::convex_hull(points);
      return hull.triangles.empty() ? point(points[0]) : solid(hull);
    }
  }
}

void stretch(Polytope& p, const Vertex& factors) {
  for (Vertex& v : p.vertices)
    for (std::size_t i = 0; i < 3; ++i) v[i] *= factors[i];
}

}  // namespace

TEST_CASE("sums of boxes are boxes", "[convex][sum]") {
  const Polytope a = solid(test::box({0, 0, 0}, {1, 2, 3})), b = solid(test::box({-1, 5, 0}, {4, 6, 7}));
  const Polytope expected = solid(test::box({-1, 5, 0}, {5, 8, 10}));
  const Polytope found = sum(a, b);
  CHECK(found.vertices == expected.vertices);
  CHECK(canonical_form(mesh_of(found)) == canonical_form(mesh_of(expected)));
}

TEST_CASE("nothing plus anything is nothing, a point moves", "[convex][sum]") {
  const Polytope a = solid(test::box({0, 0, 0}, {1, 2, 3}));
  CHECK(sum(a, {}).dimension == -1);
  CHECK(sum({}, {}).dimension == -1);
  CHECK(sum(point({1, 2, 3}), point({4, 4, 4})).vertices == std::vector<Vertex>{{5, 6, 7}});
  CHECK(sum(point({1, 1, 1}), a).vertices.front() == Vertex{1, 1, 1});
}

// Catches: facets that are parallel, arcs through nodes, arcs on arcs, a sum of other dimension than its operands.
TEST_CASE("sums of polytopes on small lattices are the hulls of all sums of vertices", "[convex][sum][property]") {
  std::array<int, 4> of_dimension{};
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Polytope a = random_polytope(random), b = random_polytope(random);
    REQUIRE(test::not_hull(a, test::pair_sums(a, point({0, 0, 0}))) == "");
    if (random.below(4) == 0) {  // scales of doubles that no common integers of fixed width hold
      const Vertex factors{std::ldexp(1.0, 900), 1, std::ldexp(1.0, -900)};
      stretch(a, factors);
      if (random.below(2) == 0) stretch(b, factors);
    } else if (random.below(4) == 0) {  // a wide lattice
      stretch(a, {1 + 0x1p-50, 1, 1 - 0x1p-40});
      stretch(b, {1, 1 + 0x1p-30, 0x1p20});
    }
    const Polytope found = sum(a, b);
    REQUIRE(test::not_hull(found, test::pair_sums(a, b)) == "");
    ++of_dimension[static_cast<std::size_t>(found.dimension)];
    const Polytope turned = sum(b, a);
    REQUIRE(turned.vertices == found.vertices);
    REQUIRE(turned.facets.size() == found.facets.size());
  }
  for (const int count : of_dimension) CHECK(count > 20);
}

// Catches: rounded sums taken for exact ones.
TEST_CASE("sums of sums are exact in rationals", "[convex][sum][property]") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Polytope a = random_polytope(random), b = random_polytope(random), c = random_polytope(random);
    stretch(a, {1, 0x1p900, 0x1p-900});
    stretch(b, {1, 0x1.8p-70, 0x1p-900});
    stretch(c, {0x1.4p60, 1, 1});
    const Polytope ab = sum(a, b), left = sum(ab, c), right = sum(a, sum(b, c));
    REQUIRE(test::not_hull(ab, test::pair_sums(a, b)) == "");
    REQUIRE(test::not_hull(left, test::pair_sums(ab, c)) == "");
    REQUIRE(left.vertices == right.vertices);
    REQUIRE(left.exact.size() == right.exact.size());
    REQUIRE(left.facets.size() == right.facets.size());
  }
}

}  // namespace strata::convex
