#include "strata/rounding.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <utility>

#include "strata/check.h"
#include "strata/combine.h"
#include "strata/errors.h"
#include "strata/primitives.h"
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
  RoundedMesh r = round_to_solid(exact, grid, {.measure = true});
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

TEST_CASE("vertices that stay at their nearest doubles count as moved", "[rounding]") {
  // All of it moves.
  const Solid third = make_box({0, 0, 0}, {1, 1, 1}).scaled(Rational(1, 3)).translated({Rational(1, 7), 0, 0});
  const RoundedMesh all = check_rounded(third.exact_mesh(), {});
  CHECK(all.mesh == third.mesh());
  CHECK(all.report.moved_vertices == 8);
  CHECK(all.report.far_vertices == 0);
  CHECK(all.report.largest_movement > 0);
  // Part of it does.
  const Solid sphere = make_sphere(2, 48), tool = third.translated({1, 1, 1}), cut = sphere - tool;
  const RoundedMesh some = check_rounded(cut.exact_mesh(), {});
  const std::array operands{Operand{sphere.mesh(), {}}, Operand{tool.mesh(), tool.exact_mesh().exact}};
  const BooleanResult result =
      combine(Operation::difference, operands, {.input = InputClass::solid, .rounding = CoordinateGrid()});
  CHECK(some.mesh == cut.mesh());
  CHECK(some.report.moved_vertices == cut.exact_mesh().exact.size());
  REQUIRE(result.rounding.has_value());
  CHECK(result.rounding->moved_vertices == some.report.moved_vertices);
  CHECK(result.rounding->largest_movement == some.report.largest_movement);
}

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
  CHECK(nothing.report.vanished_components == 1);
  const Solid both = plate | box({20, 0, 0}, {21, 1, 1});
  const RoundedMesh one = check_rounded(both.exact_mesh(), steps(1));
  CHECK(one.mesh.triangles.size() == 12);
  REQUIRE(one.report.exact.has_value());
  CHECK(one.report.exact->components == 2);
  CHECK(one.report.rounded->components == 1);
  CHECK(one.report.largest_movement <= 0.5);
  CHECK(one.report.vanished_faces == 12);
  CHECK(one.report.vanished_components == 1);
  const RoundedMesh brief = round_to_solid(both.exact_mesh(), steps(1));
  CHECK(brief.mesh == one.mesh);
  CHECK(brief.report.vanished_components == 1);
  CHECK_FALSE(brief.report.exact.has_value());
  CHECK(brief.report.is_rearranged);
  CHECK_FALSE(round_to_solid(both.exact_mesh()).report.is_rearranged);
  // `combine` has measured the exact result when it is rounded.
  const Mesh other = test::box({20, 0, 0}, {21, 1, 1});
  const MeshView views[] = {plate.mesh(), other};
  const BooleanResult measured = combine(Operation::union_, views, {.rounding = steps(1), .measure = true});
  REQUIRE(measured.rounding.has_value());
  REQUIRE(measured.rounding->exact.has_value());
  CHECK(measured.measured->measures.topology.components == 2);
  CHECK(measured.rounding->exact->components == 2);
  CHECK(measured.rounding->rounded->components == 1);
  // A plate as thin that stands on a box shares vertices with faces of it.
  const Solid fin = box({0, 0, 0}, {10, 10, 10}) | box({2, 2, 10}, {8, 2.25, 13});
  const RoundedMesh box_alone = check_rounded(fin.exact_mesh(), steps(1));
  CHECK(box_alone.report.vanished_faces > 0);
  CHECK(box_alone.report.vanished_components == 0);
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

namespace {

/// A prism over a triangle: six vertices, the three lower ones first.
Solid wedge(const std::vector<Vertex>& vertices) {
  return Solid(
      Mesh{vertices, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}, {0, 2, 1}, {3, 4, 5}}});
}

}  // namespace

TEST_CASE("two wedges of a few units, nearly in one plane", "[csg][rounding][regression]") {
  // Each time that they were resolved there were more crossings.
  const Solid a = wedge({{0.46816141303677655, -0.5836521165964841, -1.0948851548382337},
                         {1.394741994329219, -0.29687174087767937, -0.8515634696674691},
                         {1.3947419943292187, -0.29687174087767854, -0.8515634696674697},
                         {-0.6203619086514246, 0.7733989409584163, 1.450835172432719},
                         {0.30621867264101776, 1.060179316677221, 1.6941568576034836},
                         {0.30621867264101765, 1.060179316677222, 1.6941568576034831}});
  const Solid b = wedge({{0.571285817412974, -0.7122162724855796, -1.3360613310647949},
                         {1.4978663987054162, -0.4254358967667723, -1.092739645894032},
                         {1.497866398705416, -0.42543589676677146, -1.0927396458940324},
                         {-0.6493504666022556, 0.8095386840767865, 1.518630468834132},
                         {0.27723011469018644, 1.0963190597955939, 1.761952154004895},
                         {0.2772301146901863, 1.0963190597955947, 1.7619521540048946}});
  for (const Solid& solid : {a | b, a ^ b, a - b}) {
    const RoundedMesh r = check_rounded(solid.exact_mesh(), {});
    CHECK(r.report.rounds < 40);
    CHECK(r.report.largest_movement < 1e-12);
  }
}

// Wrong faces were needles, whose planes were not found: doubles lose the normal of a triangle a few units high. Each
// time that they were resolved there were more of them; at 2^970, products overflow besides.
TEST_CASE("three tetrahedra of a few units, nearly in one plane", "[csg][rounding][regression]") {
  const std::vector<Triangle> sides{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const int exponent : {-600, 0, 970}) {
    const auto tetrahedron = [&](std::vector<Vertex> corners) {
      for (Vertex& v : corners)
        for (double& x : v) x = std::ldexp(x, exponent);
      return Solid(Mesh{std::move(corners), sides});
    };
    const Solid a = tetrahedron({{-1, -0.9795814163637188, -0.38927029147619496},
                                 {1, -0.9795814163637189, -0.38927029147619485},
                                 {-1, 0.5501029582052583, 0.8991650829991871},
                                 {1, -0.9795814163637422, -0.3892702914761672}});
    const Solid b = tetrahedron({{-1, -0.979581416363719, -0.38927029147619463},
                                 {1, -0.9795814163637188, -0.3892702914761949},
                                 {-1, 0.5501029582052582, 0.8991650829991871},
                                 {-1, -0.9795814163637235, -0.38927029147618925}});
    const Solid c = tetrahedron({{-0.9989995001667084, -0.9803458760024677, -0.3899141869472465},
                                 {1.000999499833375, -0.9788161918828461, -0.3886257517875103},
                                 {-1.000999499833375, 0.5493377337243857, 0.8985205433105024},
                                 {-0.9989995001667084, -0.9803458760024915, -0.3899141869472182}});
    const RoundedMesh r = check_rounded((a ^ b ^ c).exact_mesh(), {});
    CHECK(r.report.rounds < 40);
    CHECK(r.report.largest_movement / r.report.unit < 40);
  }
}

TEST_CASE("wedges of a small angle and a ball through them", "[csg][rounding][regression]") {
  // The reach of repairs grew until the ball had vanished.
  const Solid a = wedge({{0.23932441151202719, -1.1925029375677845, 0.5933465221860951},
                         {0.6197993217486554, -0.7204599439647872, 1.3885912988874265},
                         {0.6197993217486645, -0.7204599439647875, 1.3885912988874223},
                         {-0.2909386085399539, 1.4496855675683678, -0.7213113382634101},
                         {0.08953630169667424, 1.921728561171365, 0.0739334384379212},
                         {0.08953630169668335, 1.9217285611713648, 0.07393343843791698}});
  const Solid b = wedge({{0.21556065365259547, -1.074093156985925, 0.534430079058196},
                         {0.5960355638892509, -0.6020501633829283, 1.3296748557595146},
                         {0.5960355638892599, -0.6020501633829286, 1.3296748557595104},
                         {-0.3430636148996842, 1.7094134524590154, -0.8505425815246924},
                         {0.037411295336971254, 2.181456446062012, -0.05529780482337369},
                         {0.0374112953369803, 2.1814564460620116, -0.05529780482337791}});
  Mesh ball = make_sphere(1e-4, 8).mesh();
  for (Vertex& v : ball.vertices) v = {v[0] + 0.2, v[1] + 0.3, v[2] + 0.2};
  const Solid solid = a ^ b ^ Solid(ball);
  const RoundedMesh r = check_rounded(solid.exact_mesh(), {});
  CHECK(r.report.rounds < 80);
  CHECK(r.report.largest_movement < 1e-9);
  CHECK((Solid(r.mesh) & Solid(ball)).volume() > Solid(ball).volume() * Rational(99, 100));
}

namespace {

/// The symmetric difference of square plates, each turned about the z axis and tilted by a little more than the last.
Solid turned_plates(int count, double tilt) {
  Solid all;
  for (int k = 0; k < count; ++k) {
    Mesh plate = test::box({-1, -1, -0.003}, {1, 1, 0.003});
    const double turn = k, up = k * tilt;
    for (Vertex& v : plate.vertices) {
      const double across = v[1] * std::cos(up) - v[2] * std::sin(up);
      v = {v[0] * std::cos(turn) - across * std::sin(turn), v[0] * std::sin(turn) + across * std::cos(turn),
           v[1] * std::sin(up) + v[2] * std::cos(up)};
    }
    all = all ^ Solid(plate);
  }
  return all;
}

}  // namespace

TEST_CASE("plates nearly in one plane keep their volume", "[csg][rounding][regression]") {
  // Their sheets cross at angles of a unit in their width. The reach of repairs grew until 0.02 % of the volume was
  // left, though plates are 50,000 units thick.
  const Solid solid = turned_plates(6, 1e-6);
  const RoundedMesh r = check_rounded(solid.exact_mesh(), floats());
  CHECK(r.report.largest_movement / r.report.unit < 12);
  CHECK(abs(Rational(Solid(r.mesh).volume() - solid.volume())) < solid.volume() / 10000);
}

namespace {

/// Plates above each other, turned about the z axis, the x axis and the z axis: rounding bends their facets.
Mesh turned_stack(int count, const Vertex& turns) {
  Mesh stack;
  for (int k = 0; k < count; ++k) {
    const double low = static_cast<double>(k) / count - 0.5;
    const Mesh plate = test::box({-1, -1, low}, {1, 1, low + 0.01});
    const auto first = static_cast<std::uint32_t>(stack.vertices.size());
    stack.vertices.insert(stack.vertices.end(), plate.vertices.begin(), plate.vertices.end());
    for (const auto& [a, b, c] : plate.triangles) stack.triangles.push_back({first + a, first + b, first + c});
  }
  for (Vertex& v : stack.vertices)
    for (std::size_t n = 0; n < 3; ++n) {
      double &x = v[n == 1 ? 1 : 0], &y = v[n == 1 ? 2 : 1];
      const double c = std::cos(turns[n]), s = std::sin(turns[n]);
      std::tie(x, y) = std::pair(c * x - s * y, s * x + c * y);
    }
  return stack;
}

}  // namespace

TEST_CASE("where facets bend in their diagonals, rounding has nothing to repair", "[csg][rounding][regression]") {
  // Each line in which two facets cross is bent by less than a unit where it meets a diagonal. Flat triangles beside
  // those bends crossed when rounded, and repairs of two stacks of 40 plates took minutes.
  const Solid solid = Solid(turned_stack(12, {1.1, 0.7, 1.4})) | Solid(turned_stack(12, {0.3, 1.2, 2.5}));
  for (const CoordinateGrid& grid : {CoordinateGrid(), floats()})
    CHECK(check_rounded(solid.exact_mesh(), grid).report.rounds == 0);
}

TEST_CASE("two solids and their copies of other magnitudes round alike", "[csg][rounding][regression]") {
  for (const int exponent : {-530, 0, 530}) {
    Mesh a = make_sphere(1, 14).mesh(), b = a;
    for (Vertex& v : a.vertices)
      v = {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
    for (Vertex& v : b.vertices)
      v = {std::ldexp(v[0] - 1e-15 * v[1], exponent), std::ldexp(v[1] + 1e-15 * v[0], exponent),
           std::ldexp(v[2], exponent)};
    const RoundedMesh r = check_rounded((Solid(a) ^ Solid(b)).exact_mesh(), {});
    CHECK(r.report.rounds < 30);
    CHECK(r.report.largest_movement / r.report.unit < 12);
  }
}

// Where products underflow, no pile was found; two sheets of 56 triangles at 1e-308 did not become a solid in minutes.
TEST_CASE("sheets nearly in one plane among the smallest numbers", "[csg][rounding][regression]") {
  const double unit = 0x1p-34;  // of numbers at 2^-1040
  Solid all;
  for (int k = 0; k < 4; ++k) {
    Mesh plate = test::box({-1, -1, -4 * unit}, {1, 1, 4 * unit});
    for (Vertex& v : plate.vertices) {
      const double x = v[0], y = v[1], z = v[2] + 32 * unit * k * x - 16 * unit * k * 1.37 * y;
      v = {std::ldexp(x + 0.01 * k * y, -1040), std::ldexp(y - 0.013 * k * x, -1040), std::ldexp(z, -1040)};
    }
    all = all ^ Solid(plate);
  }
  const RoundedMesh r = check_rounded(all.exact_mesh(), {});
  CHECK(r.report.rounds < 30);  // 16; 53 without piles
  CHECK(r.report.largest_movement / r.report.unit < 50);
}

TEST_CASE("a ball within one unit vanishes, however many vertices it has", "[csg][rounding][regression]") {
  Mesh ball = make_sphere(1e-8, 200).mesh();
  for (Vertex& v : ball.vertices) v[0] += 1;
  CHECK(check_rounded({ball, {}}, floats()).mesh.triangles.empty());
}

TEST_CASE("short sides collapse without repairs", "[csg][rounding]") {
  // A corner is cut off by less than the step.
  const Solid cube = box({0, 0, 0}, {8, 8, 8});
  const Solid cut = cube - Solid(test::tetrahedron({8.5, 8.5, 8.5}, {6.5, 8.5, 8.5}, {8.5, 6.5, 8.5}, {8.5, 8.5, 6.5}));
  REQUIRE(cut.exact_mesh().mesh.triangles.size() > 12);
  const RoundedMesh r = check_rounded(cut.exact_mesh(), steps(2));
  CHECK(r.report.rounds == 0);
  CHECK(r.report.vanished_faces > 0);
  CHECK(Solid(r.mesh) == cube);
}

TEST_CASE("shells that rounding turns inside out are gone", "[csg][rounding]") {
  // A flat pyramid, whose top goes below its base, far from a cube and within one.
  const Solid cube = box({0, 0, 0}, {8, 8, 8});
  Mesh flat = test::tetrahedron({2, 2, 2}, {6, 2, 2}, {2, 6, 2}, {3, 3, 2.4});
  for (const double z : {-20.0, 0.0}) {
    Mesh moved = flat;
    for (Vertex& v : moved.vertices) v[2] += z;
    const Solid part(moved);
    const Solid solid = z == 0 ? cube - part : cube | part;
    const RoundedMesh r = check_rounded(solid.exact_mesh(), steps(1));
    CHECK(Solid(r.mesh) == cube);
  }
}

TEST_CASE("a small shell of a large mesh that rounding turns inside out is gone", "[csg][rounding]") {
  // Its top is below an oblique base, and rounds to a point above it; nothing else moves.
  const double u = 0x1p-52;
  const auto at = [&](const Rational& x, const Rational& y, const Rational& z) {
    return RationalPoint{1 + to_rational(u) * x, 1 + to_rational(u) * y, 1 + to_rational(u) * z};
  };
  const std::array<RationalPoint, 4> corners{at(0, 0, 0), at(4, 0, 1), at(0, 4, 1),
                                             at(Rational(7, 5), Rational(7, 5), Rational(13, 20))};
  for (const double x : {-5.0, 1.0}) {  // beside the ball and, reversed, within it
    ExactMesh mesh{make_sphere(1, 40).mesh(), {}};
    for (Vertex& v : mesh.mesh.vertices) v = {v[0] + x, v[1] + 1, v[2] + 1};
    const Mesh ball = mesh.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.mesh.vertices.size());
    for (const RationalPoint& p : corners)
      mesh.mesh.vertices.push_back({to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])});
    mesh.exact.push_back({first + 3, corners[3]});
    for (const Triangle& t : {Triangle{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
      mesh.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      if (x > 0) std::swap(mesh.mesh.triangles.back()[1], mesh.mesh.triangles.back()[2]);
    }
    CHECK(Solid(mesh).components().size() == (x > 0 ? 1 : 2));
    CHECK(Solid(check_rounded(mesh, {}).mesh) == Solid(ball));
  }
}

TEST_CASE("what is constructed at doubles has not moved", "[csg][rounding]") {
  const Mesh a = test::box({0, 0, 0}, {1, 1, 1}), b = test::box({0.5, 0.25, 0.5}, {1.5, 0.75, 1.5});
  const MeshView views[] = {a, b};
  const BooleanResult result = combine(Operation::union_, views, {.rounding = CoordinateGrid()});
  REQUIRE(result.rounding.has_value());
  CHECK(result.rounding->moved_vertices == 0);
  CHECK(result.rounding->largest_movement == 0);
}

TEST_CASE("results rounded by combine are those of their exact vertices", "[csg][rounding][property]") {
  std::size_t rearranged = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    // Two copies of a solid, the second one turned by less and less.
    const Mesh a = round_to_solid(random_solid(seed, 3).exact_mesh()).mesh;
    Mesh b = a;
    const double angle = std::ldexp(1.0, -static_cast<int>(seed) * 2);
    for (Vertex& v : b.vertices) v = {v[0] - angle * v[1], v[1] + angle * v[0], v[2]};
    const MeshView views[] = {a, b};
    const auto operation = static_cast<Operation>(seed % 4);
    for (const CoordinateGrid& grid : {CoordinateGrid(), floats(), steps(Rational(1, 1000))}) {
      const BooleanResult rounded =
          combine(operation, views, {.input = InputClass::overlapping, .rounding = grid, .measure = true});
      const BooleanResult exact =
          combine(operation, views, {.input = InputClass::overlapping, .exact_vertices = true, .rounding = grid});
      CHECK_FALSE(exact.rounding.has_value());
      const RoundedMesh expected = round_to_solid({exact.mesh, exact.exact}, grid, {.measure = true});
      REQUIRE(rounded.rounding.has_value());
      CHECK(rounded.mesh == expected.mesh);
      CHECK(rounded.exact.empty());
      CHECK(rounded.rounding->rounds == expected.report.rounds);
      CHECK(rounded.rounding->is_rearranged == expected.report.exact.has_value());
      CHECK(rounded.rounding->moved_vertices == expected.report.moved_vertices);
      CHECK(rounded.rounding->vanished_faces == expected.report.vanished_faces);
      CHECK(rounded.rounding->vanished_components == expected.report.vanished_components);
      CHECK(rounded.rounding->exact.has_value() == expected.report.exact.has_value());
      if (rounded.rounding->exact && expected.report.exact)
        CHECK(rounded.rounding->exact->euler == expected.report.exact->euler);
      REQUIRE(rounded.sources.size() == rounded.mesh.triangles.size());
      for (std::size_t t = 0; t < rounded.sources.size(); ++t)
        REQUIRE(rounded.sources[t] == exact.sources[expected.source_face[t]]);
      rearranged += rounded.rounding->rounds > 0 ? 1 : 0;
    }
  }
  CHECK(rearranged > 5);
}

TEST_CASE("same bytes for any number of threads", "[csg][rounding]") {
  const Solid solid = random_solid(7, 9);
  Options one;
  one.threads = 1;
  for (const CoordinateGrid& grid : {floats(), steps(Rational(1, 20))})
    CHECK(round_to_solid(solid.exact_mesh(), grid, one).mesh == round_to_solid(solid.exact_mesh(), grid).mesh);
}
