#include "strata/primitives.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "strata/strata.h"
#include "support/shapes.h"

using namespace strata;

namespace {

const double pi = std::acos(-1);

void check_solid(const Solid& solid, std::int64_t euler) {
  CHECK(check(solid.mesh()).empty());
  CHECK(solid.notes().empty());
  CHECK(topology(solid.exact_mesh()).euler == euler);
  CHECK(solid.components().size() == 1);
}

double volume_of(const Solid& solid) { return to_nearest_double(solid.volume()); }

}  // namespace

TEST_CASE("boxes and tetrahedra", "[primitives]") {
  CHECK(make_box({1, 2, 3}, {2, 4, 6}) == Solid(test::box({1, 2, 3}, {2, 4, 6})));
  check_solid(make_box({-1, -2, -3}, {0.1, 0.2, 0.3}), 2);
  const Vertex a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  CHECK(make_tetrahedron(a, b, c, d).volume() == Rational(1, 6));
  CHECK(make_tetrahedron(a, c, b, d) == make_tetrahedron(a, b, c, d));
  CHECK(make_tetrahedron(d, b, c, a) == make_tetrahedron(a, b, c, d));
  check_solid(make_tetrahedron(a, b, c, d), 2);
  CHECK_THROWS_AS(make_box({0, 0, 0}, {1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(make_box({0, 0, 0}, {1, std::nan(""), 1}), std::invalid_argument);
  CHECK_THROWS_AS(make_tetrahedron(a, b, c, {0.5, 0.25, 0}), std::invalid_argument);
}

TEST_CASE("cylinders and cones are inscribed in what they are called after", "[primitives]") {
  for (const std::uint32_t sides : {3U, 4U, 7U, 48U, 1000U}) {
    CAPTURE(sides);
    const double polygon = sides / 2.0 * std::sin(2 * pi / sides);
    const Solid cylinder = make_cylinder(2, 3, sides), cone = make_cone(2, 0, 3, sides);
    check_solid(cylinder, 2);
    check_solid(cone, 2);
    check_solid(make_cone(0, 1, 1e-9, sides), 2);
    check_solid(make_cone(1e5, 0.1, 1e5, sides), 2);
    CHECK(volume_of(cylinder) == Approx(polygon * 12).epsilon(1e-12));
    CHECK(volume_of(cone) == Approx(polygon * 4).epsilon(1e-12));
    CHECK(cylinder.mesh().triangles.size() == 4 * sides - 4);
    for (const Vertex& v : cylinder.mesh().vertices) CHECK(std::hypot(v[0], v[1]) == Approx(2).epsilon(1e-15));
  }
  CHECK(make_cylinder(1, 1, 4).volume() == 2);
  CHECK_THROWS_AS(make_cylinder(0, 1, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_cylinder(1, 0, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_cylinder(1, 1, 2), std::invalid_argument);
  CHECK_THROWS_AS(make_cylinder(1, 1, 20'000'000), std::invalid_argument);
  CHECK_THROWS_AS(make_cone(-1, 1, 1, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_cone(0, 0, 1, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_cone(1, std::numeric_limits<double>::infinity(), 1, 8), std::invalid_argument);
}

TEST_CASE("spheres have their vertices on the sphere", "[primitives]") {
  for (const std::uint32_t sides : {3U, 4U, 5U, 8U, 33U, 100U}) {
    CAPTURE(sides);
    const Solid sphere = make_sphere(2, sides);
    check_solid(sphere, 2);
    for (const Vertex& v : sphere.mesh().vertices) CHECK(std::hypot(v[0], v[1], v[2]) == Approx(2).epsilon(1e-15));
    CHECK(volume_of(sphere) < 4 * pi / 3 * 8);
  }
  CHECK(volume_of(make_sphere(1, 400)) == Approx(4 * pi / 3).epsilon(1e-3));
  CHECK(make_sphere(1, 4) == Solid(test::octahedron({0, 0, 0}, 1)));
  CHECK_THROWS_AS(make_sphere(0, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_sphere(1, 2), std::invalid_argument);
}

TEST_CASE("tori have one handle", "[primitives]") {
  for (const std::uint32_t sides : {3U, 4U, 17U, 60U}) {
    CAPTURE(sides);
    check_solid(make_torus(3, 1, sides, 12), 0);
    check_solid(make_torus(1, 0.999, sides, 5), 0);
  }
  CHECK(volume_of(make_torus(3, 1, 300, 200)) == Approx(2 * pi * pi * 3).epsilon(1e-3));
  CHECK_THROWS_AS(make_torus(1, 1, 8, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_torus(1, 0, 8, 8), std::invalid_argument);
  CHECK_THROWS_AS(make_torus(1, 0.5, 8, 2), std::invalid_argument);
}

TEST_CASE("prisms stand on any simple polygon, in either direction", "[primitives]") {
  using Polygon = std::vector<std::array<double, 2>>;
  const Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Polygon reversed(l.rbegin(), l.rend());
  const Solid prism = make_prism(l, -1, 1);
  check_solid(prism, 2);
  CHECK(prism.volume() == 6);
  CHECK(make_prism(reversed, -1, 1) == prism);
  const Polygon with_corner_in_side{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(make_prism(with_corner_in_side, 0, 1) == make_box({0, 0, 0}, {2, 2, 1}));
  CHECK_THROWS_AS(make_prism(Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 3}}, 0, 1), InputError);          // crosses itself
  CHECK_THROWS_AS(make_prism(Polygon{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, 0, 1), InputError);  // touches itself
  CHECK_THROWS_AS(make_prism(Polygon{{0, 0}, {1, 1}, {2, 2}}, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(make_prism(l, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(make_prism(Polygon{{0, 0}, {1, 1}}, 0, 1), std::invalid_argument);
}

TEST_CASE("primitives are operands like any others", "[primitives]") {
  const Solid part = make_box({-2, -2, -1}, {2, 2, 1}) - make_cylinder(1, 2, 64).translated({0, 0, -1});
  CHECK(topology(part.exact_mesh()).euler == 0);
  CHECK(part.volume() + make_cylinder(1, 2, 64).volume() == 32);
}

TEST_CASE("the example of the README", "[primitives]") {
  const Solid block = make_box({0, 0, 0}, {4, 4, 2});
  const Solid part = block - make_cylinder(1, 2, 64).translated({2, 2, 0});
  const auto [below, above] = part.split({{0, 0, 1}, Rational(1, 3)});
  CHECK(below.volume() + above.volume() == part.volume());
  CHECK(below.volume() * 5 == above.volume());
  const auto pieces = above.rotated({3, 0, 0, 1}).components();
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].volume() == above.volume());
}
