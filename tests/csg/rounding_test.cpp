#include "strata/rounding.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "strata/check.h"
#include "strata/errors.h"
#include "strata/solid.h"
#include "support/shapes.h"

using namespace strata;

namespace {

CoordinateGrid floats() { return {CoordinateGrid::Format::float32, 0}; }
CoordinateGrid steps(const Rational& step) { return {CoordinateGrid::Format::float64, step}; }

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }

bool is_on(const CoordinateGrid& grid, const Mesh& mesh) {
  for (const Vertex& v : mesh.vertices)
    for (const double x : v) {
      if (grid.format == CoordinateGrid::Format::float32 && static_cast<double>(static_cast<float>(x)) != x)
        return false;
      if (grid.step == 0) continue;
      const Rational steps = to_rational(x) / grid.step;  // near an integer
      if (abs(Rational(steps - Rational(std::nearbyint(to_nearest_double(steps))))) > Rational(1, 1000000))
        return false;
    }
  return true;
}

/// What is promised of every result.
RoundedMesh check_rounded(const ExactMesh& exact, const CoordinateGrid& grid) {
  RoundedMesh r = round_to_solid(exact, grid);
  std::string errors;
  for (const Defect& d : check(r.mesh))
    if (d.severity == Severity::error) errors += describe(d) + "\n";
  INFO(errors);
  CHECK(errors.empty());
  CHECK(is_on(grid, r.mesh));
  REQUIRE(r.source_face.size() == r.mesh.triangles.size());
  for (const std::uint32_t f : r.source_face) REQUIRE(f < exact.mesh.triangles.size());
  const RoundedMesh again = round_to_solid({r.mesh, {}}, grid);
  CHECK(again.mesh == r.mesh);
  CHECK(again.report.rounds == 0);
  CHECK(again.report.largest_movement == 0);
  return r;
}

Solid random_solid(unsigned seed, int operands) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-1, 1);
  Solid solid;
  for (int k = 0; k < operands; ++k) {
    std::array<Vertex, 6> points;
    for (Vertex& p : points)
      for (double& x : p) x = at(random);
    const Solid next(test::convex_hull(points));
    solid = k % 4 == 3 ? solid - next : k % 4 == 2 ? solid ^ next : solid | next;
  }
  return solid;
}

}  // namespace

TEST_CASE("a solid on the grid is not changed", "[csg][rounding]") {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  for (const CoordinateGrid& grid : {CoordinateGrid(), floats(), steps(1), steps(Rational(1, 1000)), steps(0.125)}) {
    const RoundedMesh r = check_rounded(cube.exact_mesh(), grid);
    CHECK(r.mesh == cube.mesh());
    CHECK(r.report.rounds == 0);
    CHECK(r.report.moved_vertices == 0);
  }
  CHECK(round_to_solid({}).mesh.triangles.empty());
}

TEST_CASE("what is thinner than the grid vanishes, and the report says so", "[csg][rounding]") {
  const Solid plate = box({0, 0, 0}, {10, 10, 0.25});
  const RoundedMesh nothing = check_rounded(plate.exact_mesh(), steps(1));
  CHECK(nothing.mesh.triangles.empty());
  CHECK(nothing.report.vanished_faces == 12);
  const Solid both = plate | box({20, 0, 0}, {21, 1, 1});
  const RoundedMesh one = check_rounded(both.exact_mesh(), steps(1));
  CHECK(one.mesh.triangles.size() == 12);
  REQUIRE(one.report.exact.has_value());
  CHECK(one.report.exact->components == 2);
  CHECK(one.report.rounded->components == 1);
  CHECK(one.report.largest_movement <= 0.5);
}

TEST_CASE("two solids that round onto each other become one, or keep their common face out", "[csg][rounding]") {
  const double gap = std::nextafter(1.0, 2.0);
  const Solid both = box({0, 0, 0}, {1, 1, 1}) | box({gap, 0, 0}, {2, 1, 1});
  CHECK(both.components().size() == 2);
  const RoundedMesh r = check_rounded(both.exact_mesh(), floats());
  CHECK(Solid(r.mesh) == box({0, 0, 0}, {2, 1, 1}));
  CHECK(check_rounded(both.exact_mesh(), {}).mesh == both.mesh());
}

TEST_CASE("decimal grids give the doubles nearest to decimals", "[csg][rounding]") {
  const RoundedMesh r = check_rounded(box({0.1234567, 0, 0}, {1.9999999, 1, 1}).exact_mesh(), steps(Rational(1, 1000)));
  CHECK(r.mesh.vertices.front()[0] == 0.123);
  CHECK(r.mesh.vertices.back()[0] == 2.0);
  CHECK(r.report.largest_movement < 0.0005);
  CHECK(
      check_rounded(box({0.0151, 0, 0}, {1.9999999, 1, 1}).exact_mesh(), steps(Rational(3, 200))).mesh.vertices[0][0] ==
      0.015);
  CHECK(check_rounded(box({0.1, 0, 0}, {1, 1, 1}).exact_mesh(), steps(to_rational(0.1))).report.rounds == 0);
  CHECK_THROWS_AS(round_to_solid({}, steps(Rational(1, (Integer(1) << 60) + 1))), std::invalid_argument);
  CHECK_THROWS_AS(round_to_solid({}, steps(-1)), std::invalid_argument);
}

TEST_CASE("coordinates beyond floats are refused by name", "[csg][rounding]") {
  const Solid huge = box({0, 0, 0}, {1e39, 1, 1});
  CHECK_THROWS_WITH(round_to_solid(huge.exact_mesh(), floats()), Catch::Contains("beyond the largest number"));
  CHECK(check_rounded(huge.exact_mesh(), {}).report.rounds == 0);
}

TEST_CASE("extreme magnitudes", "[csg][rounding]") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  CHECK(check_rounded(box({0, 0, 0}, {tiny, tiny, tiny}).exact_mesh(), {}).mesh.triangles.size() == 12);
  CHECK(check_rounded(box({0, 0, 0}, {tiny, tiny, tiny}).exact_mesh(), floats()).mesh.triangles.empty());
  for (const double size : {1e300, 1e-300}) {
    const double next = std::nextafter(size, std::numeric_limits<double>::infinity());
    const Solid shell = box({-next, -next, -next}, {next, next, next}) - box({-size, -size, -size}, {size, size, size});
    CHECK(check_rounded(shell.exact_mesh(), {}).report.rounds == 0);
    // A third of it is cut off, obliquely.
    const Solid cut = shell - Solid(test::tetrahedron({3 * size, 0, 0}, {0, 3 * size, 0}, {0, 0, 3 * size},
                                                      {4 * size, 4 * size, 4 * size}));
    check_rounded(cut.exact_mesh(), {});
  }
}

TEST_CASE("constructed vertices near the largest double", "[csg][rounding]") {
  const double m = std::numeric_limits<double>::max();
  const Solid cut = box({-m, -m, -m}, {m, m, m}) - Solid(test::tetrahedron({m, m, 0}, {0, m, m}, {m, 0, m}, {m, m, m}));
  const RoundedMesh r = check_rounded(cut.exact_mesh(), {});
  CHECK(r.mesh.triangles.size() == cut.mesh().triangles.size());
  CHECK(std::isfinite(r.report.largest_movement));
  const Solid third =
      box({0, 0, 0}, {m, m, m}) -
      box({-1, -1, -1}, {m, m, m})
          .transformed(Transform({{{1, 0, 0, 0}, {0, Rational(1, 3), 0, 0}, {0, Rational(1, 7), Rational(1, 3), 0}}}));
  check_rounded(third.exact_mesh(), {});
}

TEST_CASE("a needle shorter than a unit in the last place", "[csg][rounding]") {
  const double e = 0x1p-50;
  const Solid needle(test::tetrahedron({1, 1, 1}, {1 + e, 1, 1}, {1, 1 + e, 1}, {1, 1, 2}));
  const Solid cut = needle - box({0, 0, 1.5}, {3, 3, 3}) - box({0, 0, 0}, {3, 3, 1.25});
  check_rounded(cut.exact_mesh(), {});
  CHECK(check_rounded(cut.exact_mesh(), floats()).mesh.triangles.empty());
}

TEST_CASE("random solids are solids on every grid", "[csg][rounding][property]") {
  const std::vector<CoordinateGrid> grids{
      {}, floats(), steps(Rational(1, 100)), steps(Rational(1, 20)), steps(0.125), steps(Rational(1, 5)), steps(0.5)};
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Solid solid = random_solid(seed, 5);
    INFO("seed " << seed);
    for (const CoordinateGrid& grid : grids) {
      INFO("step " << to_nearest_double(grid.step));
      check_rounded(solid.exact_mesh(), grid);
    }
  }
}

TEST_CASE("a fan of sheets about one edge", "[csg][rounding]") {
  // Wedges around the z axis, which is turned by a rational rotation: the edge is rounded, the sheets are close there.
  std::vector<Solid> wedges;
  constexpr int count = 60;
  for (int k = 0; k < count; ++k) {
    const double a = 6.283 * k / count, b = 6.283 * (k + 0.5) / count;
    wedges.push_back(Solid(test::prism(
        std::array<std::array<double, 2>, 3>{{{0, 0}, {std::cos(a), std::sin(a)}, {std::cos(b), std::sin(b)}}}, -1,
        1)));
  }
  Solid fan;
  for (const Solid& w : wedges) fan = fan | w;
  const Rational c(3, 5), s(4, 5);
  const Solid turned = fan.transformed(
      Transform({{{c, -s, 0, Rational(1, 3)}, {s * c, c * c, -s, Rational(1, 7)}, {s * s, s * c, c, 0}}}));
  check_rounded(turned.exact_mesh(), {});
  check_rounded(turned.exact_mesh(), floats());
  check_rounded(turned.exact_mesh(), steps(Rational(1, 64)));
}

TEST_CASE("same bytes for any number of threads", "[csg][rounding]") {
  const Solid solid = random_solid(7, 9);
  Options one;
  one.threads = 1;
  for (const CoordinateGrid& grid : {floats(), steps(Rational(1, 20))})
    CHECK(round_to_solid(solid.exact_mesh(), grid, one).mesh == round_to_solid(solid.exact_mesh(), grid).mesh);
}
