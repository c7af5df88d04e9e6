#include "core/kernel/filtered_plane.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/predicates.h"
#include "support/random.h"

using namespace strata;

TEST_CASE("a plane in doubles is certain only of what is so", "[kernel]") {
  const InputComplex::Coordinates a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const FilteredPlane plane(a, b, c);
  CHECK(plane.side({0.3, 0.3, 1}) == 1);
  CHECK(plane.side({0.3, 0.3, -1e-200}) == -1);
  CHECK(plane.side({5, 7, 0}) == 0);
  CHECK(FilteredPlane().side({1, 2, 3}) == 0);
  CHECK(plane.widest_axis() == 2);
  const FilteredPlane huge({0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0});
  CHECK(huge.side({0, 0, 1}) == 0);  // it overflows: nothing is certain
}

TEST_CASE("identified vertices stand for each other in faces", "[kernel]") {
  const std::vector<InputComplex::Coordinates> first{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      second{{1, 0, 0}, {0, 0, 0}, {0, 0, 1}};
  const std::vector<InputComplex::Indices> faces{{0, 1, 2}};
  InputComplex input;
  input.add(first, faces);
  input.add(second, faces);
  const std::pair<std::uint32_t, std::uint32_t> equal[] = {{1, 3}, {0, 4}};
  input.identify(equal);
  CHECK(input.face(0) == InputComplex::Indices{0, 1, 2});
  CHECK(input.face(1) == InputComplex::Indices{1, 0, 5});
  CHECK(input.is_shared(3));
  CHECK(input.is_shared(1));
  CHECK_FALSE(input.is_shared(5));
  CHECK(input.vertex(3) == input.vertex(1));
  const std::pair<std::uint32_t, std::uint32_t> more[] = {{3, 2}};
  input.identify(more);
  CHECK(input.identified(3) == 1);
  CHECK(input.identified(2) == 1);
}

TEST_CASE("a plane is certain of a point within bounds only if it is of every place there", "[kernel][property]") {
  test::Random random(11);
  int certain = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::array<InputComplex::Coordinates, 3> t;
    for (auto& v : t)
      for (double& x : v) x = random.unit() * 2 - 1;
    BoundedPoint p;
    const double size = std::ldexp(1.0, -random.between(0, 50));
    // Near the plane more often than not.
    const double s = random.unit(), r = random.unit(), h = random.once_in(4) ? 0.1 : size;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = {t[0][i] + s * (t[1][i] - t[0][i]) + r * (t[2][i] - t[0][i]) + h * (random.unit() - 0.5),
              size * random.unit()};
    const int side = FilteredPlane(t[0], t[1], t[2]).side_within(p);
    if (side == 0) continue;
    ++certain;
    for (int corner = 0; corner < 8; ++corner) {
      InputComplex::Coordinates at;
      for (std::size_t i = 0; i < 3; ++i) at[i] = (corner >> i & 1) != 0 ? p[i].upper() : p[i].lower();
      REQUIRE(to_int(orient3d(t[0], t[1], t[2], at)) == side);
    }
  }
  CHECK(certain > 1'000);
}
