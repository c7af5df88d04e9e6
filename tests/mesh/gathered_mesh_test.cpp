#include "core/mesh/gathered_mesh.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "core/mesh/prepare.h"
#include "shapes.h"
#include "support/shuffled.h"

using namespace strata;
using namespace strata::shapes;
using test::shuffled;

namespace {

/// The triangles by the coordinates of their corners, the corners in the order that the mesh gives them.
std::vector<std::array<Vertex, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<Vertex, 3>> all;
  for (const Triangle& t : mesh.triangles)
    all.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  std::sort(all.begin(), all.end());
  return all;
}

double mean_jump(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t f = 1; f < mesh.triangles.size(); ++f)
    sum += std::abs(static_cast<double>(mesh.triangles[f][0]) - static_cast<double>(mesh.triangles[f - 1][0]));
  return sum / static_cast<double>(mesh.triangles.size());
}

}  // namespace

TEST_CASE("a gathered mesh has the same triangles, near one another", "[mesh]") {
  const Mesh mesh = shuffled(globe(100), 1);
  const Mesh near = gathered(mesh, {});
  CHECK(triangles_of(near) == triangles_of(mesh));
  CHECK(near.vertices.size() == mesh.vertices.size());
  CHECK(screen(near).chain_closed);
  CHECK(mean_jump(near) < mean_jump(mesh) / 20);
}

TEST_CASE("the gathered mesh is the same for any number of threads, and for vertices in one place", "[mesh]") {
  for (const Mesh& mesh : {shuffled(globe(60), 2), scaled(shuffled(globe(20), 3), 0), scaled(globe(9), 5e-324),
                           scaled(globe(30), std::numeric_limits<double>::max()), Mesh{}, Mesh{{{1, 2, 3}}, {}}}) {
    const Mesh once = gathered(mesh, {});
    CHECK(once == gathered(mesh, {}));
    CHECK(triangles_of(once) == triangles_of(mesh));
  }
}

TEST_CASE("large meshes are scattered where neighbours in the list are far apart", "[mesh]") {
  const Mesh ordered = globe(400);
  REQUIRE(ordered.vertices.size() > 100'000);
  CHECK_FALSE(is_scattered(ordered));
  const Mesh mesh = shuffled(ordered, 4);
  CHECK(is_scattered(mesh));
  CHECK_FALSE(is_scattered(gathered(mesh, {})));
  CHECK_FALSE(is_scattered(shuffled(globe(50), 5)));  // small ones are in the cache
  Mesh wrong = mesh;
  wrong.triangles[7] = {0, 1, 0xffff'ffff};
  CHECK(is_scattered(wrong));
}
