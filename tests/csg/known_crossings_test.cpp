#include <catch2/catch.hpp>
#include <random>

#include "core/csg/boolean.h"
#include "core/mesh/equal_vertices.h"
#include "core/overlap/self_intersections.h"
#include "csg/complex_of.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh all = a;
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  all.vertices.insert(all.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) all.triangles.push_back({i + first, j + first, k + first});
  return all;
}

FacePairs crossings_of(const Mesh& mesh) {
  FacePairs pairs;
  for (const SelfIntersection& s : find_self_intersections(test::complex_of(mesh), nullptr, Monitor()))
    pairs.emplace_back(s.face, s.other);
  return pairs;
}

/// Two spheres that cross, somewhere.
Mesh crossing_spheres(unsigned seed) {
  std::mt19937 random(seed);
  const auto some = [&] { return std::uniform_real_distribution<>(-1, 1)(random); };
  return joined(test::icosphere({0, 0, 0}, 1, 3), test::icosphere({some(), some(), 1 + some() / 2}, 1, 3));
}

}  // namespace

TEST_CASE("a mesh whose crossings are known is resolved as one in which they are found", "[csg][property]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = crossing_spheres(seed);
    const FacePairs crossings = crossings_of(mesh);
    const BooleanResult found = resolved(test::complex_of(mesh), Inside::winding, Monitor());
    const BooleanResult known = resolved(test::complex_of(mesh), Inside::winding, Monitor(), &crossings);
    REQUIRE(known.mesh.vertices == found.mesh.vertices);
    REQUIRE(known.mesh.triangles == found.mesh.triangles);
    REQUIRE(known.sources == found.sources);
    REQUIRE(known.exact.size() == found.exact.size());
    for (std::size_t i = 0; i < known.exact.size(); ++i) REQUIRE(known.exact[i].position == found.exact[i].position);
  }
}

// Boxes that touch in edges and have vertices of their own there, and far from them boxes that cross: where crossings
// are many, cells find the equal vertices.
TEST_CASE("a mesh that lists vertices several times is resolved with known crossings as without", "[csg][property]") {
  std::size_t most_faces_cross = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    Mesh mesh;
    const int side = 1 + static_cast<int>(random() % 5);
    for (int i = 0; i < side; ++i)
      for (int j = i % 2; j < side; j += 2)
        mesh = joined(mesh, test::box({double(i), double(j), 0}, {double(i + 1), double(j + 1), 1}));
    for (auto count = 2 + random() % 12; count-- > 0;) {
      const Vertex low{30 + between(0, 1), between(0, 1), between(0, 1)};
      mesh = joined(mesh, test::box(low, {low[0] + between(.1, 1), low[1] + between(.1, 1), low[2] + between(.1, 1)}));
    }
    const Mesh welded{mesh.vertices, on_first_vertices(ExactMeshView(mesh, {}))};
    const FacePairs crossings = crossings_of(welded);
    most_faces_cross += crossings.size() > mesh.triangles.size() / 8;
    const BooleanResult found = resolved(test::complex_of(welded), Inside::winding, Monitor());
    const BooleanResult known = resolved(test::complex_of(mesh), Inside::winding, Monitor(), &crossings);
    REQUIRE(known.mesh == found.mesh);
    REQUIRE(known.sources == found.sources);
  }
  CHECK(most_faces_cross > 20);
}

TEST_CASE("crossings that are known are all that count", "[csg]") {
  const Mesh mesh = crossing_spheres(0);
  const FacePairs none;
  const BooleanResult result = resolved(test::complex_of(mesh), Inside::winding, Monitor(), &none);
  CHECK(result.exact.empty());  // nothing was cut
}
