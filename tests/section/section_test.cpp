#include "strata/section.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "extensions/section/general_position.h"
#include "strata/primitives.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }

Rational area_at(const Solid& solid, double z) { return planar::area(section(solid, {{0, 0, 1}, z})); }

/// Solids on a small grid, so that planes at integers go through vertices, edges and faces.
class RandomSolids {
 public:
  explicit RandomSolids(unsigned seed) : random_(seed) {}

  Solid solid() {
    std::vector<Solid> parts;
    for (int n = number(1, 4); n > 0; --n) parts.push_back(number(0, 1) == 0 ? random_box() : hull());
    Solid whole = union_(parts);
    return number(0, 1) == 0 ? whole : whole - random_box();
  }
  int number(int least, int most) { return std::uniform_int_distribution<>(least, most)(random_); }

 private:
  Vertex point() {
    return {static_cast<double>(number(0, 4)), static_cast<double>(number(0, 4)), static_cast<double>(number(0, 4))};
  }
  Solid random_box() {
    const Vertex a = point();
    return box(a, {a[0] + number(1, 3), a[1] + number(1, 3), a[2] + number(1, 3)});
  }
  Solid hull() {
    std::vector<Vertex> points;
    for (int i = 0; i < 6; ++i) points.push_back(point());
    const Mesh mesh = test::convex_hull(points);
    return mesh.triangles.empty() ? random_box() : Solid(mesh);
  }

  std::mt19937 random_;
};

/// What a region is, point by point, in its order.
struct Listed {
  std::vector<std::vector<planar::RationalPlacement>> loops;
  std::vector<std::uint32_t> first_loop;
  std::vector<bool> is_double;  ///< of every corner

  friend bool operator==(const Listed&, const Listed&) = default;
};

Listed listed(const planar::Region& region) {
  Listed list;
  list.first_loop = region.first_loop;
  const planar::Places& places = region.loops.places;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    auto& loop = list.loops.emplace_back();
    for (const std::uint32_t v : region.loops.loop(l)) {
      loop.push_back(planar::exact_position(places, v));
      list.is_double.push_back(places.is_double(v));
      for (std::size_t i = 0; i < 2; ++i) REQUIRE(places.place[v][i] == to_nearest_double(loop.back()[i]));
    }
  }
  return list;
}

/// Slices are the sections that any plane gives, which go through an arrangement always.
void check_slices(const Solid& solid, std::span<const double> heights) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RationalPoint normal{0, 0, 0};
    normal[axis] = 1;
    const std::vector<planar::Region> slices = slice(solid, axis, heights);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      CAPTURE(axis, heights[k]);
      REQUIRE(listed(slices[k]) == listed(section(solid, {normal, heights[k]})));
      REQUIRE(planar::validate(slices[k]).empty());
    }
  }
}

}  // namespace

TEST_CASE("a box is closed below and open above", "[section]") {
  const Solid solid = box({0, 0, 0}, {2, 3, 1});
  CHECK(area_at(solid, 0) == 6);
  CHECK(area_at(solid, 0.5) == 6);
  CHECK(area_at(solid, 1) == 0);
  CHECK(area_at(solid, -0.5) == 0);
  CHECK(planar::area(section(solid, {{0, 0, -1}, 0})) == 0);  // seen from below, z = 0 is the top
  CHECK(planar::area(section(solid, {{0, 0, -1}, -1})) == 6);
}

TEST_CASE("planes through edges and vertices only have no section", "[section]") {
  const Solid solid = box({0, 0, 0}, {1, 1, 1});
  CHECK(section(solid, {{1, 1, 1}, 3}).empty());
  CHECK(section(solid, {{1, 1, 1}, 0}).empty());
  CHECK(section(solid, {{1, 1, 0}, 2}).empty());
  CHECK(section(Solid(), {{0, 0, 1}, 0}).empty());
  CHECK_THROWS_AS(section(solid, {{0, 0, 0}, 0}), std::invalid_argument);
}

TEST_CASE("a hexagon of a cube", "[section]") {
  const Solid solid = box({0, 0, 0}, {1, 1, 1});
  const Plane plane{{1, 1, 1}, Rational(3, 2)};
  const planar::Region hexagon = section(solid, plane);
  REQUIRE(hexagon.loops.size() == 1);
  CHECK(hexagon.loops.loop(0).size() == 6);
  CHECK(planar::area(hexagon) == Rational(3, 4));
  CHECK(true_area(plane, planar::area(hexagon)) == Approx(3 * std::sqrt(3.0) / 4).epsilon(1e-15));
  for (const std::uint32_t v : hexagon.loops.loop(0))
    CHECK(plane.side(point_in(plane, planar::exact_position(hexagon.loops.places, v))) == 0);
}

TEST_CASE("axes turn counter-clockwise as seen from in front", "[section]") {
  for (const int sign : {1, -1})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      RationalPoint normal{0, 0, 0};
      normal[axis] = sign;
      const PlaneAxes axes = axes_of({normal, 0});
      CHECK(axes.left_out == axis);
      CHECK(axes.u == (sign > 0 ? (axis + 1) % 3 : (axis + 2) % 3));
    }
  // An L-shaped prism is not its own mirror image.
  const std::vector<std::array<double, 2>> triangle{{0, 0}, {2, 0}, {0, 1}};
  const Solid solid(test::prism(triangle, 0, 1));
  const planar::Region from_above = section(solid, {{0, 0, 1}, 0.5});
  CHECK(planar::canonical_form(from_above) ==
        planar::canonical_form(planar::fill(planar::loops_of(std::vector<std::vector<planar::PlanePoint>>{triangle}))));
}

TEST_CASE("holes and islands", "[section]") {
  const Solid solid = (box({0, 0, 0}, {9, 9, 9}) - box({1, 1, 1}, {8, 8, 8})) | box({3, 3, 3}, {4, 4, 4});
  const planar::Region region = section(solid, {{0, 0, 1}, 3.5});
  CHECK(region.polygons() == 2);
  CHECK(planar::area(region) == 81 - 49 + 1);
}

TEST_CASE("slices are sections", "[section]") {
  const Solid solid = make_sphere(2, 24) - make_cylinder(1, 9, 12).translated({0, 0, -4});
  std::vector<double> heights{-3, -2, -1, -0.25, 0, 0, 0.125, 1, 2, 2.5};
  for (const Vertex& p : solid.mesh().vertices) heights.push_back(p[2]);
  std::sort(heights.begin(), heights.end());
  for (const unsigned threads : {1U, 2U}) {
    const std::vector<planar::Region> regions = slice(solid, 2, heights, {.threads = threads});
    REQUIRE(regions.size() == heights.size());
    for (std::size_t k = 0; k < heights.size(); k += 7) {
      CHECK(planar::canonical_form(regions[k]) == planar::canonical_form(section(solid, {{0, 0, 1}, heights[k]})));
      CHECK(planar::validate(regions[k]).empty());
    }
  }
}

TEST_CASE("slices of random solids are sections, in general position and not", "[section]") {
  const std::vector<double> heights{-1, 0,   0x1p-40, 0.1,  1.0 / 3, 0.5, 1, 1.2, 1.5,
                                    2,  2.3, 2.5,     2.75, 3.1,     3.5, 4, 4.5, 9};
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    RandomSolids solids(seed);
    const Solid solid = solids.solid();
    check_slices(solid, heights);
    check_slices(solid.separated(), heights);
    check_slices(solid.scaled(Rational(1, 3)), heights);
    check_slices(solid.rotated({1, 2, 3}, 20.0 * seed), heights);
  }
}

TEST_CASE("vertices and faces in the plane need no arrangement, touching does", "[section]") {
  const auto is_in_general_position = [](const Solid& solid, double height) {
    std::vector<std::uint32_t> all(solid.mesh().triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return section_in_general_position(solid.mesh().triangles, all, {2, height, solid.exact_mesh()}).has_value();
  };
  const Solid cube = box({0, 0, 0}, {2, 2, 2});
  for (const double height : {-1.0, 0.0, 1.0, 2.0, 3.0}) CHECK(is_in_general_position(cube, height));
  const Solid sphere = make_sphere(2, 24);
  for (const Vertex& p : sphere.mesh().vertices) CHECK(is_in_general_position(sphere, p[2]));
  CHECK(is_in_general_position(cube.scaled(Rational(1, 3)), 1.0 / 3));
  const Solid touching = cube | cube.translated({2, 2, 0});
  CHECK_FALSE(is_in_general_position(touching, 1));
  CHECK_FALSE(is_in_general_position(touching.separated(), 1));
}

TEST_CASE("slices with holes within holes", "[section]") {
  std::vector<Solid> shells;
  for (const double x : {0.0, 10.0, 20.0})
    for (const double y : {0.0, 10.0})
      for (int k = 0; k < 4; ++k)
        shells.push_back(
            make_sphere(4 - k, 12 + k).rotated({1.0, 1.0 * k, 2.0}, 7 * k).translated({x, y, static_cast<double>(k)}));
  const Solid solid = symmetric_difference(shells);
  const std::vector<double> heights{-2.1, -1.05, 0.1, 0.3, 1.1, 1.9, 2.2, 2.6, 3.05, 3.9};
  check_slices(solid, heights);
  CHECK(slice(solid, 2, std::vector{2.2}).front().loops.size() == 24);
  // A plate with many holes in each of several islands.
  Solid plate = box({0, 0, 0}, {20, 20, 1}) | box({1, 21, 0}, {20, 22, 1}) | box({8, 8, 0}, {9, 9, 1});
  std::vector<Solid> holes{plate};
  for (int i = 0; i < 18; ++i)
    for (int j = 0; j < 18; ++j) holes.push_back(box({i + 1.25, j + 1.25, -1}, {i + 1.75, j + 1.75, 2}));
  const Solid sieve = difference(holes);
  check_slices(sieve, std::vector{0.5});
  CHECK(slice(sieve, 2, std::vector{0.5}).front().loops.size() == 2 + 324);
}

TEST_CASE("a hole beside an island that is bent around it", "[section]") {
  const Solid notch = box({2, 2, -1}, {18, 6, 2}) | box({2, 2, -1}, {6, 18, 2});
  const Solid island = box({3, 3, 0}, {17, 5, 1}) | box({3, 3, 0}, {5, 17, 1});
  const Solid solid = (box({0, 0, 0}, {20, 20, 1}) - notch - box({10, 10, -1}, {12, 12, 2})) | island;
  check_slices(solid, std::vector{0.0, 0.5});
  CHECK(slice(solid, 2, std::vector{0.5}).front().first_loop == std::vector<std::uint32_t>{0, 3, 4});
}

TEST_CASE("slices of tiny and of huge solids are sections", "[section]") {
  for (const double scale : {5e-324, 1e-300, 1e-150, 1e150, 1e300, 1.5e308}) {
    CAPTURE(scale);
    const std::vector<Vertex> unit{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    Mesh mesh = test::convex_hull(unit);
    for (Vertex& p : mesh.vertices)
      for (double& x : p) x *= scale;
    const std::vector<double> heights{
        -scale, -scale / 2, -scale / 3, 0, scale / 7, scale / 4, std::nextafter(scale, 0)};
    check_slices(Solid(mesh), heights);
  }
}

TEST_CASE("a mesh that is no solid is cut all the same", "[section]") {
  // Taken at its word, it crosses itself; or it has a face twice.
  Mesh mesh = test::box({0, 0, 0}, {2, 2, 2});
  const Mesh other = test::box({1, 1, 1}, {3, 3, 3});
  for (Triangle t : other.triangles) {
    for (std::uint32_t& v : t) v += 8;
    mesh.triangles.push_back(t);
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  CHECK(planar::area(slice(Solid(mesh, InputClass::solid), 2, std::vector{1.5}).front()) == 8);
  CHECK(planar::area(slice(Solid(mesh), 2, std::vector{1.5}).front()) == 7);
  Mesh twice = test::box({0, 0, 0}, {2, 2, 2});
  const Mesh once = twice;
  twice.triangles.insert(twice.triangles.end(), once.triangles.begin(), once.triangles.end());
  CHECK(planar::area(slice(Solid(twice, InputClass::solid), 2, std::vector{1.5}).front()) == 4);
}

TEST_CASE("along every axis", "[section]") {
  const Solid solid = box({0, 0, 0}, {1, 2, 3});
  const std::vector<double> at{0.5};
  CHECK(planar::area(slice(solid, 0, at).front()) == 6);
  CHECK(planar::area(slice(solid, 1, at).front()) == 3);
  CHECK(planar::area(slice(solid, 2, at).front()) == 2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RationalPoint normal{0, 0, 0};
    normal[axis] = 1;
    CHECK(planar::canonical_form(slice(solid, axis, at).front()) ==
          planar::canonical_form(section(solid, {normal, 0.5})));
  }
}

TEST_CASE("what slices refuse", "[section]") {
  const Solid solid = box({0, 0, 0}, {1, 1, 1});
  CHECK_THROWS_AS(slice(solid, 3, std::vector{0.5}), std::invalid_argument);
  CHECK_THROWS_AS(slice(solid, 2, std::vector{0.5, 0.25}), std::invalid_argument);
  CHECK_THROWS_AS(slice(solid, 2, std::vector{std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  CHECK(slice(solid, 2, std::span<const double>()).empty());
  CancelToken token;
  token.cancel();
  CHECK_THROWS_AS(slice(solid, 2, std::vector{0.5}, {.cancel = &token}), Cancelled);
  CHECK_THROWS_AS(section(solid, {{0, 0, 1}, 0.5}, {.cancel = &token}), Cancelled);
}

TEST_CASE("an exact solid is cut exactly", "[section]") {
  const Solid third = box({0, 0, 0}, {1, 1, 1}).scaled(Rational(1, 3));
  CHECK(area_at(third, 0.25) == Rational(1, 9));
  CHECK(area_at(third, 1.0 / 3) == Rational(1, 9));  // the double is less than a third
  CHECK(area_at(third, std::nextafter(1.0 / 3, 1)) == 0);
  CHECK(planar::area(section(third, {{0, 0, 3}, 1})) == 0);
  CHECK(planar::area(section(third, {{0, 0, -3}, -1})) == Rational(1, 9));
  const std::vector<double> heights{0, 0.25, 1.0 / 3, 1};
  const std::vector<planar::Region> regions = slice(third, 2, heights);
  CHECK(planar::area(regions[2]) == Rational(1, 9));
  CHECK(regions[3].empty());
}

TEST_CASE("tiny and huge", "[section]") {
  for (const double scale : {1e-300, 1e-150, 1e150, 1e300}) {
    const Solid solid = box({0, 0, 0}, {scale, scale, scale});
    CHECK(area_at(solid, scale / 3) == Rational(scale) * Rational(scale));
    const planar::Region corner = section(solid, {{1, 1, 1}, Rational(scale)});
    CHECK(planar::area(corner) == Rational(scale) * Rational(scale) / 2);
  }
}

TEST_CASE("sections of Booleans are Booleans of sections", "[section]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    RandomSolids solids(seed);
    const Solid a = solids.solid(), b = solids.solid();
    const RationalPoint normal = solids.number(0, 1) == 0
                                     ? RationalPoint{0, 0, 1}
                                     : RationalPoint{solids.number(-2, 2), solids.number(-2, 2), solids.number(1, 2)};
    const Plane plane{normal, Rational(solids.number(0, 12), solids.number(1, 3))};
    const planar::Region in_a = section(a, plane), in_b = section(b, plane);
    REQUIRE(planar::validate(in_a).empty());
    for (const Operation operation : all_operations) {
      const planar::Region of_result = section(combine_solids(operation, {a, b}), plane);
      const std::vector<planar::Operand> operands{in_a, in_b};
      REQUIRE(planar::canonical_form(of_result) == planar::canonical_form(planar::combine(operands, operation)));
    }
  }
}

TEST_CASE("the integral of a prism's sections is its volume", "[section]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomSolids solids(seed);
    const Solid solid = solids.solid();
    // Between planes through vertices the area is a polynomial of degree two in the height: Simpson's rule is exact.
    // All vertices have rational heights; those of boxes and hulls are integers, their crossings are not.
    std::vector<Rational> heights;
    for (std::uint32_t v = 0; v < solid.mesh().vertices.size(); ++v)
      heights.push_back(solid.exact_mesh().position(v)[2]);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    const auto area = [&](const Rational& z) { return planar::area(section(solid, {{0, 0, 1}, z})); };
    Rational volume = 0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      const Rational low = heights[i], high = heights[i + 1], middle = (low + high) / 2;
      // The section at `high` seen from below: that of the opposite plane.
      const Rational top = planar::area(section(solid, {{0, 0, -1}, -high}));
      volume += (high - low) / 6 * (area(low) + 4 * area(middle) + top);
    }
    REQUIRE(volume == solid.volume());
  }
}
