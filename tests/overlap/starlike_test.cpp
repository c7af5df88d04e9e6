#include "core/overlap/starlike.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/overlap/self_intersections.h"
#include "support/append.h"
#include "support/random.h"
#include "support/shapes.h"

using namespace strata;

namespace {

bool is_found(const Mesh& mesh) { return is_found_starlike(mesh, Monitor()); }

/// A double cone over a polygon, given by the angles of its corners from one to the next in twelfths of a turn.
Mesh cone_over(std::size_t corners, int step) {
  constexpr std::array<std::array<double, 2>, 12> circle{{{16, 0},
                                                          {14, 8},
                                                          {8, 14},
                                                          {0, 16},
                                                          {-8, 14},
                                                          {-14, 8},
                                                          {-16, 0},
                                                          {-14, -8},
                                                          {-8, -14},
                                                          {0, -16},
                                                          {8, -14},
                                                          {14, -8}}};
  Mesh mesh{{{0, 0, 8}, {0, 0, -8}}, {}};
  for (std::size_t i = 0; i < corners; ++i) {
    const auto& [x, y] = circle[i * static_cast<std::size_t>(step) % 12];
    mesh.vertices.push_back({x + 0.125 * static_cast<double>(i), y, 0});
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t here = i + 2, after = static_cast<std::uint32_t>((i + 1) % corners) + 2;
    mesh.triangles.push_back({here, after, 0});
    mesh.triangles.push_back({after, here, 1});
  }
  return mesh;
}

}  // namespace

TEST_CASE("balls, boxes and double cones are starlike; open, reversed, moved and damaged ones are not", "[overlap]") {
  for (int level = 0; level <= 5; ++level) CHECK(is_found(test::icosphere({0.1, 0.2, 0.3}, 1, level)));
  CHECK(is_found(test::box({0, 0, 0}, {1, 1, 1})));
  CHECK_FALSE(is_found(test::box({-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308})));  // its size is no double
  CHECK(is_found(test::cube_grid(9)));
  CHECK(is_found(cone_over(12, 1)));
  CHECK_FALSE(is_found({}));

  const Mesh ball = test::icosphere({0, 0, 0}, 1, 4);
  for (const std::size_t f : {std::size_t{0}, ball.triangles.size() / 2, ball.triangles.size() - 1}) {
    Mesh open = ball, reversed = ball, wrong = ball, unknown = ball;
    open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(f));
    CHECK_FALSE(is_found(open));
    std::swap(reversed.triangles[f][0], reversed.triangles[f][1]);
    CHECK_FALSE(is_found(reversed));
    wrong.triangles[f][0] = static_cast<std::uint32_t>(ball.vertices.size());
    CHECK_FALSE(is_found(wrong));
    unknown.vertices[ball.triangles[f][0]][1] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(is_found(unknown));
    unknown.vertices[ball.triangles[f][0]][1] = std::numeric_limits<double>::infinity();
    CHECK_FALSE(is_found(unknown));
  }
  Mesh inside_out = ball;
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK_FALSE(is_found(inside_out));
}

// Catches: faces counted that the ray does not meet, and a count that is not compared with one.
TEST_CASE("closed meshes that go round more than once are not starlike, though each face is seen from inside",
          "[overlap]") {
  CHECK_FALSE(is_found(cone_over(12, 5)));  // five times
  CHECK_FALSE(is_found(cone_over(12, 7)));  // backwards
  Mesh twice = test::icosphere({0, 0, 0}, 1, 3);
  test::append(twice, test::icosphere({0, 0, 0}, 1.25, 3));
  CHECK_FALSE(is_found(twice));
  Mesh hollow = test::icosphere({0, 0, 0}, 2, 3), cavity = test::icosphere({0, 0, 0}, 1, 3);
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  test::append(hollow, cavity);
  CHECK_FALSE(is_found(hollow));
  Mesh apart = test::box({0, 0, 0}, {1, 1, 1});
  test::append(apart, test::box({2, 0, 0}, {3, 1, 1}));
  CHECK_FALSE(is_found(apart));
}

// Radii are far apart from vertex to vertex, so that many of these meshes hide parts of themselves or cross themselves.
TEST_CASE("what is found starlike has no faces that intersect", "[overlap][property]") {
  int found = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Mesh mesh = seed % 2 == 0 ? test::icosphere({0, 0, 0}, 8, 1) : cone_over(9, 1);
    for (Vertex& v : mesh.vertices)
      for (double& x : v) x = std::round(x + (seed % 4 < 2 ? 1 : 7) * (random.unit() - 0.5));
    InputComplex input(SelfIntersections::possible);
    input.add(mesh.vertices, mesh.triangles);
    const bool starlike = is_found(mesh);
    if (starlike) CHECK(find_self_intersections(input, nullptr, Monitor()).empty());
    (starlike ? found : others) += 1;
  }
  CHECK(found > 20);
  CHECK(others > 20);
}
