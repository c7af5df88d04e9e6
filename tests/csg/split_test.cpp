#include <catch2/catch.hpp>
#include <limits>

#include "strata/strata.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::box;

namespace {

/// The halves are solids on their sides, and together the solid.
void check_halves(const Solid& solid, const Plane& plane) {
  const auto [behind, in_front] = solid.split(plane);
  CHECK(behind.volume() + in_front.volume() == solid.volume());
  CHECK((behind | in_front) == solid);
  CHECK((behind & in_front).is_empty());
  const auto is_on_side = [&](const Solid& half, int side) {
    for (std::uint32_t v = 0; v < half.mesh().vertices.size(); ++v)
      if (plane.side(half.exact_mesh().position(v)) * side < 0) return false;
    return true;
  };
  CHECK(is_on_side(behind, -1));
  CHECK(is_on_side(in_front, 1));
  for (const Solid& half : {behind, in_front}) CHECK((half.is_empty() || check(half.exact_mesh()).empty()));
}

Solid cube() { return Solid(box({0, 0, 0}, {2, 2, 2})); }

}  // namespace

TEST_CASE("a plane divides a solid into what is behind and what is in front of it", "[csg]") {
  const auto [behind, in_front] = cube().split({{0, 0, 1}, 0.5});
  CHECK(behind == Solid(box({0, 0, 0}, {2, 2, 0.5})));
  CHECK(in_front == Solid(box({0, 0, 0.5}, {2, 2, 2})));
  const auto turned = cube().split({{0, 0, -3}, -1.5});
  CHECK(turned.behind == in_front);
  CHECK(turned.in_front == behind);
  CHECK(cube().split({{0, 0, 1}, Rational(1, 3)}).behind.volume() == Rational(4, 3));
}

TEST_CASE("planes through vertices, edges and faces, and planes that miss the solid", "[csg]") {
  for (const Plane& plane : {Plane{{1, 1, 1}, 2}, Plane{{1, 1, 1}, 4}, Plane{{1, -1, 0}, 0}, Plane{{1, 1, 0}, 2},
                             Plane{{1, 1, -1}, 2}, Plane{{3, 5, 7}, Rational(50, 7)}, Plane{{0, 1, 0}, 1}})
    check_halves(cube(), plane);
  for (const Plane& plane : {Plane{{1, 1, 1}, 6}, Plane{{1, 1, 0}, 4}, Plane{{1, 0, 0}, 2}, Plane{{1, 2, 3}, 100}}) {
    CHECK(cube().split(plane).behind == cube());
    CHECK(cube().split(plane).in_front.is_empty());
    CHECK(cube().split(plane.opposite()).in_front == cube());
    CHECK(cube().split(plane.opposite()).behind.is_empty());
  }
  CHECK(Solid().split({{1, 0, 0}, 0}).behind.is_empty());
  CHECK_THROWS_AS(cube().split({{0, 0, 0}, 1}), std::invalid_argument);
}

TEST_CASE("faces in the plane stay on their side", "[csg]") {
  const Solid l(test::l_shape());
  for (const double at : {0.0, 1.0, 2.0})
    for (const RationalPoint& normal : {RationalPoint{1, 0, 0}, RationalPoint{0, 1, 0}, RationalPoint{0, 0, 1}})
      check_halves(l, {normal, at});
  check_halves(Solid(test::box_with_cavity(2)), {{0, 0, 1}, 1});
  check_halves(Solid(test::box_with_cavity(2)), {{0, 0, 1}, 2});
  check_halves(Solid(test::edge_sharing_cells()), {{1, 1, 0}, 2});
}

TEST_CASE("volumes of halves add up for planes in any position", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Solid solid(test::lattice_solid(random));
    const auto lattice = [&] {
      return RationalPoint{random.between(0, 4), random.between(0, 4), random.between(0, 4)};
    };
    Plane plane = Plane::through(lattice(), lattice(), lattice());
    if (plane.normal == RationalPoint{}) plane = {{1, 2, -1}, 2};
    if (random.once_in(3)) plane.offset += Rational(random.between(-9, 9), 7);
    check_halves(solid, plane);
  }
}

TEST_CASE("a solid may be split again and again", "[csg]") {
  Solid rest(test::icosphere({0, 0, 0}, 1, 2));
  const Rational whole = rest.volume();
  Rational sum = 0;
  for (int i = 0; i < 6; ++i) {
    auto [behind, in_front] = rest.split({{i % 3 - 1, 2, i - 3}, Rational(i - 5, 11)});
    sum += behind.volume();
    rest = in_front;
  }
  CHECK(sum + rest.volume() == whole);
}

TEST_CASE("splits work at all scales of doubles", "[csg]") {
  for (const double scale : {0x1p-1000, 0x1p+900}) {
    const Solid cube(box({0, 0, 0}, {scale, scale, scale}));
    const auto [behind, in_front] = cube.split({{1, 2, 3}, scale * 2.5});
    CHECK(behind.volume() + in_front.volume() == cube.volume());
    CHECK_FALSE(behind.is_empty());
    CHECK_FALSE(in_front.is_empty());
  }
  const double most = std::numeric_limits<double>::max();
  CHECK_THROWS_AS(Solid(box({0, 0, 0}, {most, 1, 1})).split({{1, 0, 0}, 1}), std::overflow_error);
}
