#include "core/mesh/equal_vertices.h"

#include <catch2/catch.hpp>
#include <random>

#include "core/csg/boolean.h"
#include "core/overlap/self_intersections.h"
#include "support/append.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh all = a;
  test::append(all, b);
  return all;
}

}  // namespace

// Boxes that touch in edges and have vertices of their own there, and far from them boxes that cross: where crossings
// are many, cells find the equal vertices.
TEST_CASE("a mesh that lists vertices several times is resolved as one that lists them once", "[csg][property]") {
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
    most_faces_cross += find_self_intersections(complex_of(welded), nullptr, {}).size() > mesh.triangles.size() / 8;
    const BooleanResult once = resolved(complex_of(welded), Inside::winding, {});
    const BooleanResult several = resolved(complex_of(mesh), Inside::winding, {});
    REQUIRE(several.mesh == once.mesh);
    REQUIRE(several.sources == once.sources);
  }
  CHECK(most_faces_cross > 20);
}
