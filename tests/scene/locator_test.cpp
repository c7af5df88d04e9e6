#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "scene/rational_rays.h"
#include "scene/scenes.h"
#include "strata/query.h"

using namespace strata;

namespace {

/// Points all over the box about a scene, and some at its faces.
std::vector<Vertex> points_about(const std::vector<Mesh>& meshes, std::size_t count, test::Random& random) {
  Box box;
  for (const Mesh& m : meshes)
    for (const Vertex& v : m.vertices) box.include(v);
  std::vector<Vertex> points;
  while (points.size() < count) {
    Vertex q;
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = box.lower[i] + (random.unit() * 1.2 - 0.1) * (box.upper[i] - box.lower[i]);
    points.push_back(q);
    points.push_back(test::awkward_point(meshes, q, random));
  }
  return points;
}

void require_same(const std::vector<Mesh>& meshes, std::span<const Vertex> points, const Origin& origin) {
  const Scene scene = test::scene_of(meshes);
  const Locator locator(scene);
  const SignedCovering covering(scene, origin);
  const auto ours = locator.locate(points), theirs = covering.locate(points);
  std::vector<Where> where(points.size());
  locator.membership(points, where);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CAPTURE(points[i][0], points[i][1], points[i][2]);
    REQUIRE(ours[i].windings == theirs[i].windings);
    REQUIRE(ours[i].contacts == theirs[i].contacts);
    REQUIRE(where[i] == ours[i].where());
  }
}

}  // namespace

// Catches: windings of empty space, cells left out, faces larger than their cells.
TEST_CASE("cells answer as one origin does, where there are many of them", "[layers][property]") {
  test::Random random(11);
  const Mesh ball = test::icosphere({0.125, -0.25, 0.375}, 1.7, 5),
             small = test::icosphere({0.125, -0.25, 0.375}, 0.9, 4);
  const Mesh box = test::box({-1, -1, -1}, {3, 0.25, 0.5});
  require_same({ball}, points_about({ball}, 4000, random), Origin::direction({0, 0, 1}));
  require_same({ball, small, box}, points_about({ball, small, box}, 4000, random), Origin::point({0.1, 0.2, 0.3}));
  std::vector<Mesh> many;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 2; ++z) many.push_back(test::box({x * 1.0, y * 1.0, z * 1.0}, {x + 1.0, y + 1.0, z + 1.0}));
  require_same(many, points_about(many, 4000, random), Origin::point({2.5, 2.5, 1}));
}

// Catches: cells where doubles are too coarse for origins, and a small solid far from a large one.
TEST_CASE("solids of very different sizes are located, too", "[layers][degenerate]") {
  test::Random random(12);
  for (const double scale : {1e-300, 1e-9, 1e30, 1e290}) {
    CAPTURE(scale);
    Mesh ball = test::icosphere({0.5, 0.5, 0.5}, 0.25, 2), large = test::box({-1, -1, -1}, {1, 2, 3});
    for (Vertex& v : ball.vertices)
      for (double& x : v) x *= scale;
    require_same({ball, large}, points_about({ball, large}, 60, random), Origin::direction({1, 2, 3}));
    require_same({ball, large}, points_about({ball}, 60, random), Origin::direction({1, 2, 3}));
  }
}

TEST_CASE("faces a step of doubles apart enclose nothing and are told apart", "[layers][degenerate]") {
  const double far = 1e15, step = 0.125;
  std::vector<Mesh> sheets;
  for (int i = 0; i < 40; ++i)
    sheets.push_back(test::box({far + 2 * i * step, 0, 0}, {far + (2 * i + 1) * step, 1, 1}));
  const Scene scene = test::scene_of(sheets);
  const Locator locator(scene);
  for (int i = 0; i < 80; ++i) {
    const Location location = locator.locate({far + i * step, 0.5, 0.25});
    REQUIRE(location.where() == Where::on);
    REQUIRE(location.contacts.size() == 1);
    REQUIRE(location.contacts.front().solid == static_cast<std::uint32_t>(i / 2));
    REQUIRE(location.windings.begin() == location.windings.end());
  }
}

TEST_CASE("where nothing is, all is out", "[layers]") {
  const Locator nothing{Scene()};
  CHECK(nothing.membership({0, 0, 0}) == Where::out);
  CHECK(nothing.bytes() < 1'000'000);
  CHECK(nothing.locate(Vertex{1, 2, 3}).contacts.empty());
  CancelToken stop;
  stop.cancel();
  const Scene ball = test::scene_of({test::icosphere({0, 0, 0}, 1, 4)});
  CHECK_THROWS_AS(Locator(ball, Monitor(&stop)), Cancelled);
  CHECK_THROWS_AS(LayerDecomposition(ball, Origin::point({0, 0, 0}), Monitor(&stop)), Cancelled);
  CHECK_THROWS_AS(Scene({ball.solid(0)}, Monitor(&stop)), Cancelled);
}
