#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "strata/measure.h"
#include "strata/solid.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }
Solid unit(double x, double y, double z) { return box({x, y, z}, {x + 1, y + 1, z + 1}); }

/// `measure` against the functions of which it is made; facets against those of the canonical form.
void check_measures(const Solid& solid) {
  const ExactMesh& mesh = solid.exact_mesh();
  const Measures m = measure(mesh);
  REQUIRE(m.volume.has_value());
  CHECK(*m.volume == to_nearest_double(solid.volume()));
  CHECK(m.area == solid.area());
  CHECK(m.facets == canonical_form(mesh).facet_count());
  const Topology t = topology(mesh);
  CHECK(m.topology.components == t.components);
  CHECK(m.topology.euler == t.euler);
  CHECK(m.topology.non_manifold_edges == t.non_manifold_edges);
  CHECK(m.topology.non_manifold_vertices == t.non_manifold_vertices);
}

}  // namespace

TEST_CASE("facets are joined over edges, not over vertices", "[csg]") {
  CHECK(measure(unit(0, 0, 0).exact_mesh()).facets == 6);
  // In one plane, with a vertex in common: two facets.
  CHECK(measure((unit(0, 0, 0) | unit(1, 1, 0)).exact_mesh()).facets == 12);
  // A tetrahedron stands with an edge on top of a box: the top is one facet, over an edge of four triangles.
  const Solid standing(test::tetrahedron({1, 1, 1}, {2, 1, 1}, {1.5, 1.5, 2}, {1.5, 0.5, 2}));
  const Solid both = box({0, 0, 0}, {3, 2, 1}) | standing;
  CHECK(measure(both.exact_mesh()).topology.non_manifold_edges > 0);
  check_measures(both);
  // A hole that touches the rim of its facet in a vertex, and one that divides it.
  check_measures(box({0, 0, 0}, {4, 4, 1}) -
                 Solid(test::prism(std::array<std::array<double, 2>, 3>{{{0, 0}, {2, 1}, {1, 2}}}, -1, 2)));
  check_measures(box({0, 0, 0}, {4, 4, 1}) -
                 Solid(test::prism(std::array<std::array<double, 2>, 4>{{{0, 0}, {3, 1}, {4, 4}, {1, 3}}}, -1, 2)));
}

TEST_CASE("a mesh that is not closed has no volume", "[csg]") {
  Mesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const Measures m = measure({mesh, {}});
  CHECK_FALSE(m.volume.has_value());
  CHECK(m.topology.open_edges == 3);
  CHECK(measure({}).facets == 0);
  CHECK(measure({}).volume == 0.0);
}

TEST_CASE("measures of random sets of boxes agree with the canonical form", "[csg][property]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> at(0, 4), size(1, 3);
    Solid solid;
    for (int k = 0; k < 7; ++k) {
      const Vertex lower{double(at(random)), double(at(random)), double(at(random))};
      const Vertex upper{lower[0] + size(random), lower[1] + size(random), lower[2] + size(random)};
      const Transform turn = seed % 3 == 0
                                 ? Transform()
                                 : Transform({{{1, Rational(1, 3), 0, 0}, {0, 1, Rational(1, 7), 0}, {0, 0, 1, 0}}});
      const Solid next = box(lower, upper).transformed(turn);
      solid = k % 3 == 2 ? solid - next : k % 3 == 1 ? solid ^ next : solid | next;
    }
    check_measures(solid);
  }
}

TEST_CASE("measures are the same for any number of threads", "[csg]") {
  const Solid solid(test::icosphere({0, 0, 0}, 1, 5));
  Options one;
  one.threads = 1;
  const Measures a = measure(solid.exact_mesh(), one), b = measure(solid.exact_mesh());
  CHECK(a.area == b.area);
  CHECK(a.volume == b.volume);
  CHECK(a.facets == b.facets);
  CHECK(a.area == Approx(12.566370614).epsilon(0.01));
}
