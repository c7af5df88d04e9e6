#include <array>
#include <catch2/catch.hpp>

#include "strata/query.h"
#include "support/shapes.h"
#include "support/transform.h"

using namespace strata;

// Catches: vertices of the second solid taken for those of the first; exact places rounded.
TEST_CASE("a scene has the vertices and faces of its solids in one numbering", "[scene]") {
  const Mesh first = test::cube_grid(1), second = test::translated(test::cube_grid(1), {3, 0, 0});
  const Rational third = Rational(1) / 3;
  const ExactMesh exact{second, {{0, {to_rational(second.vertices[0][0]), third, third}}}};
  ExactMesh rounded = exact;
  rounded.mesh.vertices[0] = {second.vertices[0][0], to_nearest_double(third), to_nearest_double(third)};
  const Scene scene({{first, {}}, rounded});
  const auto offset = static_cast<std::uint32_t>(first.vertices.size());
  REQUIRE(scene.vertex_count() == first.vertices.size() + second.vertices.size());
  CHECK(scene.vertex(1) == first.vertices[1]);
  CHECK(scene.vertex(offset + 1) == second.vertices[1]);
  CHECK(scene.position(offset) == exact.exact[0].position);
  CHECK(scene.position(offset + 1) == rounded.position(1));
  const auto faces = static_cast<std::uint32_t>(first.triangles.size());
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(scene.face(1)[i] == first.triangles[1][i]);
    CHECK(scene.face(faces + 1)[i] == offset + second.triangles[1][i]);
  }
}

TEST_CASE("layers know which solids their origin is in", "[scene]") {
  const Solid cube(test::cube_grid(1));
  const Scene scene = scene_of({&cube, 1});
  CHECK(LayerDecomposition(scene, Origin::point({9, 8, 7})).windings_of_origin() == WindingNumbers());
  CHECK(LayerDecomposition(scene, Origin::point({0.5, 0.25, 0.375})).windings_of_origin()[0] == 1);
}
