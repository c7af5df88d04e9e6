#include "extensions/scene/signed_covering.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/pieces.h"
#include "scene/rational_rays.h"
#include "scene/scenes.h"
#include "strata/query.h"

using namespace strata;

TEST_CASE("location agrees with rational rays from any origin", "[layers][property]") {
  const auto seed = GENERATE(range(0, 150));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed) + 77);
  const auto meshes = test::touching_operands(static_cast<std::uint64_t>(seed)).meshes;
  const Origin origin = test::awkward_origin(meshes, random);
  CAPTURE(origin.is_point(), origin.at[0], origin.at[1], origin.at[2]);
  const SignedCovering covering(test::scene_of(meshes), origin);
  const Locator locator(covering.scene());
  for (int n = 0; n < 16; ++n) {
    const Vertex q = test::awkward_point(meshes, origin.at, random);
    CAPTURE(q[0], q[1], q[2]);
    const Location location = covering.locate(q);
    Where where = Where::out;
    for (std::uint32_t s = 0; s < meshes.size(); ++s) {
      CAPTURE(s);
      const auto triangles = test::triangles_of({meshes[s], {}});
      const auto on = std::find_if(triangles.begin(), triangles.end(),
                                   [&](const auto& t) { return test::is_on(t, test::rational(q)); });
      const auto contact = std::find_if(location.contacts.begin(), location.contacts.end(),
                                        [&](const Contact& c) { return c.solid == s; });
      REQUIRE((on != triangles.end()) == (contact != location.contacts.end()));
      if (on != triangles.end()) {
        where = Where::on;
        REQUIRE(covering.scene().local(contact->face) == static_cast<std::uint32_t>(on - triangles.begin()));
        continue;
      }
      const int w = test::winding_number(triangles, test::rational(q), random);
      REQUIRE(location.windings[s] == w);
      if (w != 0 && where == Where::out) where = Where::in;
    }
    REQUIRE(covering.membership(q) == where);
    REQUIRE(locator.membership(q) == where);
    const Location local = locator.locate(q);
    REQUIRE(local.windings == location.windings);
    REQUIRE(local.contacts == location.contacts);
  }
}

TEST_CASE("membership of smooth solids agrees with rational rays", "[layers][property]") {
  test::Random random(3);
  const Mesh ball = test::icosphere({0.125, -0.25, 0.375}, 1.7, 2);
  const auto triangles = test::triangles_of({ball, {}});
  for (const Origin& origin : {Origin::point({0, 0, 0}), Origin::point({0.125, -0.25, 0.375}), Origin::point({9, 1, 2}),
                               Origin::point(ball.vertices[17]), Origin::point({1e9, 1e8, -1e9}),
                               Origin::direction({1, 2, 3}), Origin::direction({0, 0, -1})}) {
    const SignedCovering covering(test::scene_of({ball}), origin);
    for (int n = 0; n < 40; ++n) {
      const Vertex q{random.between(-99, 99) / 48.0, random.between(-99, 99) / 48.0, random.between(-99, 99) / 48.0};
      const int w = test::winding_number(triangles, test::rational(q), random);
      REQUIRE(covering.membership(q) == (w == 0 ? Where::out : Where::in));
    }
    for (const std::size_t i : {0u, 100u, 150u}) REQUIRE(covering.membership(ball.vertices[i]) == Where::on);
  }
}

TEST_CASE("scales and places of all sizes are taken as they are", "[layers][degenerate]") {
  for (const double scale : {1e-300, 1e-150, 1e-30, 1.0, 1e30, 1e150, 1e300}) {
    CAPTURE(scale);
    Mesh box = test::box({0, 0, 0}, {scale, scale, scale});
    for (const Origin& origin :
         {Origin::point({scale / 3, scale / 4, scale / 5}), Origin::point({-scale, scale * 3, 0}),
          Origin::point({0, 0, 0}), Origin::direction({1, 1, 1})}) {
      const SignedCovering covering(test::scene_of({box}), origin);
      CHECK(covering.membership({scale / 2, scale / 2, scale / 2}) == Where::in);
      CHECK(covering.membership({scale / 2, scale / 2, scale}) == Where::on);
      CHECK(covering.membership({scale / 2, scale / 2, std::nextafter(scale, HUGE_VAL)}) == Where::out);
      CHECK(covering.membership({scale / 2, scale / 2, std::nextafter(scale, 0)}) == Where::in);
      CHECK(covering.membership({-scale / 2, scale / 2, scale / 2}) == Where::out);
      CHECK(covering.membership({1e308, -1e308, 1e308}) == Where::out);
    }
  }
}

TEST_CASE("differences beyond all doubles are no obstacle", "[layers][degenerate]") {
  const double far = 1.5e308;
  const Scene scene = test::scene_of({test::box({far / 2, far / 2, far / 2}, {far, far, far})});
  for (const Vertex& at : {Vertex{-far, -far, -far}, Vertex{-far, far, 0}, Vertex{0, 0, 0}}) {
    const SignedCovering covering(scene, Origin::point(at));
    const std::vector<Vertex> points{{far * 0.75, far * 0.75, far * 0.75}, {far, far * 0.75, far * 0.75}, {-far, 0, 0}};
    std::vector<Where> where(points.size());
    covering.membership(points, where);
    CHECK(where == std::vector<Where>{Where::in, Where::on, Where::out});
  }
}

TEST_CASE("an origin that is none is refused", "[layers]") {
  const Scene scene = test::scene_of({test::box({0, 0, 0}, {1, 1, 1})});
  CHECK_THROWS_AS(SignedCovering(scene, Origin::direction({0, 0, 0})), std::invalid_argument);
  CHECK_THROWS_AS(SignedCovering(scene, Origin::point({HUGE_VAL, 0, 0})), std::invalid_argument);
}
