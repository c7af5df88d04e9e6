#include <catch2/catch.hpp>
#include <random>

#include "strata/check.h"
#include "strata/measure.h"
#include "strata/solid.h"
#include "strata/transform.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }
Solid unit(double x, double y, double z) { return box({x, y, z}, {x + 1, y + 1, z + 1}); }

/// Of the mesh as it is listed: every edge has two triangles and every vertex one fan, by numbers alone.
bool is_manifold(const Mesh& mesh) {
  // Vertices at one position count as one in `topology`, so give each a position of its own.
  ExactMesh apart{mesh, {}};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) apart.mesh.vertices[v] = {static_cast<double>(v), 0, 0};
  const Topology t = topology(apart);
  return t.non_manifold_edges == 0 && t.non_manifold_vertices == 0 && t.open_edges == 0;
}

}  // namespace

TEST_CASE("cubes that touch in an edge get edges of their own", "[csg]") {
  const Solid solid = unit(0, 0, 0) | unit(1, 1, 0);
  CHECK(solid.mesh().vertices.size() == 14);
  CHECK_FALSE(is_manifold(solid.mesh()));
  const Solid separated = solid.separated();
  CHECK(separated.mesh().vertices.size() == 16);
  CHECK(separated.mesh().triangles.size() == solid.mesh().triangles.size());
  CHECK(is_manifold(separated.mesh()));
  CHECK(separated == solid);
  CHECK(separated.sources() == solid.sources());
  CHECK(separated.components().size() == 2);
  CHECK(separated.separated().mesh() == separated.mesh());
}

TEST_CASE("what touches in a vertex, and a solid that touches itself", "[csg]") {
  const Solid in_a_vertex = unit(0, 0, 0) | unit(1, 1, 1);
  CHECK(in_a_vertex.separated().mesh().vertices.size() == 16);
  CHECK(is_manifold(in_a_vertex.separated().mesh()));
  // A ring of cubes that closes in an edge: one component, whose edge is listed twice.
  const Solid ring = unit(0, 0, 0) | unit(1, 0, 0) | unit(2, 0, 0) | unit(2, 1, 0) | unit(2, 2, 0) | unit(1, 2, 0) |
                     unit(0, 1, 1) | unit(0, 0, 1) | unit(0, 1, 2) | unit(1, 1, 2);
  CHECK(is_manifold(ring.separated().mesh()));
  CHECK(ring.separated() == ring);
  const Solid cavity = box({0, 0, 0}, {3, 3, 3}) - unit(1, 1, 1) - unit(2, 2, 1);  // a cavity that touches an edge
  CHECK(is_manifold(cavity.separated().mesh()));
  CHECK(cavity.separated() == cavity);
}

TEST_CASE("a manifold stays as it is", "[csg]") {
  const Solid solid = box({0, 0, 0}, {3, 3, 3}) - box({1, 1, -1}, {2, 2, 4});
  CHECK(solid.separated().mesh() == solid.mesh());
  CHECK(Solid().separated().is_empty());
}

TEST_CASE("exact positions are copied", "[csg]") {
  const Solid third = (unit(0, 0, 0) | unit(1, 1, 0)).scaled(Rational(1, 3));
  const Solid separated = third.separated();
  CHECK(separated == third);
  CHECK(separated.exact_mesh().exact.size() > third.exact_mesh().exact.size());
  CHECK(is_manifold(separated.mesh()));
}

TEST_CASE("sets of cubes in a grid become manifolds", "[csg]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<Solid> cubes;
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z)
          if (random() % 2 == 0) cubes.push_back(unit(x, y, z));
    const Solid solid = union_(cubes);
    const Solid separated = solid.separated();
    REQUIRE(is_manifold(separated.mesh()));
    REQUIRE(separated == solid);
    REQUIRE(check(separated.exact_mesh()).empty());
    REQUIRE((separated | unit(0, 0, 0)) == (solid | unit(0, 0, 0)));
    REQUIRE((unit(0, 0, 0) - separated) == (unit(0, 0, 0) - solid));
  }
}

TEST_CASE("parts of what is listed apart are closed by their numbers", "[csg]") {
  const Mesh wedge = test::convex_hull(std::vector<Vertex>{{1, 1, 3}, {1, 2, 3}, {1, 1, 1}, {2, 1, 1}});
  const Solid touched = (box({0, 0, 0}, {3, 3, 3}) - Solid(wedge)).separated();  // a cavity touches the top from inside
  const Solid far = box({9, 9, 9}, {10, 10, 10});
  for (const Solid& solid :
       {touched, touched.transformed(Transform::scaling({Rational(1, 3), Rational(1, 3), Rational(1, 3)}))}) {
    const Solid filled = solid.without_cavities();
    CHECK(topology(filled.exact_mesh()).open_edges == 0);
    CHECK(is_manifold(filled.mesh()));
    CHECK((filled | far).volume() == filled.volume() + 1);
  }
}
