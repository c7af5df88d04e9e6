#include <tbb/task_arena.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/sight.h"
#include "extensions/scene/signed_covering.h"
#include "scene/scenes.h"
#include "strata/query.h"

using namespace strata;

namespace {

std::uint32_t flat_faces(const Scene& scene, const Origin& origin) {
  const Sight sight(input_complex_of(scene), origin);
  std::uint32_t flat = 0;
  for (std::uint32_t f = 0; f < scene.face_count(); ++f)
    flat += sight.orientation(input_complex_of(scene).face(f)) == Sign::zero;
  return flat;
}

Mesh scaled(Mesh mesh, double scale) {
  for (Vertex& v : mesh.vertices)
    for (double& x : v) x *= scale;
  return mesh;
}

}  // namespace

// Catches: outside places that win over inside ones, inside places that are outside.
TEST_CASE("a convex solid has one layer about the chosen origin", "[layers]") {
  for (const Mesh& mesh :
       {test::box({0, 0, 0}, {1, 1, 1}), test::icosphere({9, -4, 2}, 0.25, 3), test::octahedron({-7, 0, 0}, 2),
        test::tetrahedron({0, 0, 0}, {64, 0, 0}, {0, 1, 0}, {0, 0, 1})}) {
    const Scene scene = test::scene_of({mesh});
    CHECK(LayerDecomposition(scene, choose_origin(scene)).layer_count() == 1);
  }
}

// Catches: an origin that is taken as it was judged, without the check and the steps: the middle of a cube with an even
// number of cells is on planes, also when all vertices say so.
TEST_CASE("the chosen origin is on no plane of a face", "[layers][degenerate]") {
  std::vector<Mesh> cells;
  for (int i = -1; i < 1; ++i)
    for (int j = -1; j < 1; ++j)
      for (int k = -1; k < 1; ++k)
        cells.push_back(test::box({double(i), double(j), double(k)}, {i + 1.0, j + 1.0, k + 1.0}));
  const Scene grid = test::scene_of(cells);
  CHECK(flat_faces(grid, Origin::point({0, 0, 0})) != 0);
  CHECK(flat_faces(grid, choose_origin(grid)) == 0);
}

TEST_CASE("no face is flat about the chosen origin, however solids touch", "[layers][property]") {
  const auto seed = GENERATE(range(0, 100));
  CAPTURE(seed);
  const Scene scene = test::scene_of(test::touching_operands(static_cast<std::uint64_t>(seed)).meshes);
  const Origin origin = choose_origin(scene);
  REQUIRE(origin.is_point());
  REQUIRE(flat_faces(scene, origin) == 0);
}

// Catches: estimates that overflow or vanish, steps that are lost in the origin's last bits.
TEST_CASE("origins are found at all scales and far away", "[layers][degenerate]") {
  for (const double scale : {1e-320, 1e-300, 1e-150, 1.0, 1e150, 1e300, 1e308}) {
    CAPTURE(scale);
    const Scene scene = test::scene_of({scaled(test::box({-1, -1, -1}, {1, 1, 1}), scale)});
    const Origin origin = choose_origin(scene);
    CHECK(flat_faces(scene, origin) == 0);
    for (const double x : origin.at) CHECK(std::abs(x) < scale);
  }
  const double far = 0x1p52;
  const Scene scene = test::scene_of({test::box({far, far, far}, {far + 2, far + 2, far + 2})});
  CHECK(flat_faces(scene, choose_origin(scene)) == 0);
}

TEST_CASE("the chosen origin does not depend on threads", "[layers]") {
  std::vector<Mesh> meshes;
  for (int i = 0; i < 5; ++i) meshes.push_back(test::icosphere({i * 0.75, i * i * 0.1, 0.3 * (i % 2)}, 0.5, 3));
  const Scene scene = test::scene_of(meshes);
  const Origin origin = choose_origin(scene);
  for (const int threads : {1, 2, 3})
    CHECK(tbb::task_arena(threads).execute([&] { return choose_origin(scene); }) == origin);
}

TEST_CASE("an empty scene is seen from zero", "[layers]") {
  CHECK(choose_origin(Scene()) == Origin::point({0, 0, 0}));
  CHECK(choose_origin(test::scene_of({Mesh{}, Mesh{}})) == Origin::point({0, 0, 0}));
}
