#include "extensions/openscad/tessellation.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/kernel/predicates.h"
#include "core/mesh/circle.h"
#include "openscad/csg_text.h"
#include "strata/check.h"

using namespace strata;
using namespace strata::test;
using namespace strata::openscad;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A primitive as it is read: its one solid.
Mesh mesh_of(const std::string& text) {
  const auto primitives = read_csg(text, "test.csg").expression.primitives();
  REQUIRE(primitives.size() == 1);
  return primitives[0].solid.mesh();
}

bool is_degenerate(const Mesh& mesh, const Triangle& t) {
  const Vertex &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (orient2d(PlanePoint{a[i], a[j]}, PlanePoint{b[i], b[j]}, PlanePoint{c[i], c[j]}) != Sign::zero) return false;
  }
  return true;
}

void check_solid(const std::string& text) {
  CAPTURE(text);
  const Mesh mesh = mesh_of(text);
  CHECK(check(mesh).empty());
  std::size_t degenerate = 0;
  for (const Triangle& t : mesh.triangles) degenerate += is_degenerate(mesh, t);
  CHECK(degenerate == 0);
  CHECK(Solid(mesh).volume() > 0);
  CHECK(Solid(mesh).notes().empty());
}

/// Vertices of the default tessellation.
std::size_t corners_of(const std::string& text) { return mesh_of(text).vertices.size(); }

}  // namespace

TEST_CASE("circles have as many sides as OpenSCAD gives them", "[openscad]") {
  CHECK(sides_of_circle(10, {}) == 30);  // 360 / 12
  CHECK(sides_of_circle(5, {}) == 16);   // 5 pi = 15.7
  CHECK(sides_of_circle(1, {}) == 5);    // 3.1
  CHECK(sides_of_circle(1e9, {}) == 30);
  CHECK(sides_of_circle(10, {0, 5, 0.1}) == 72);      // CSG-modules of the examples
  CHECK(sides_of_circle(0.5, {0, 5, 0.1}) == 32);     // 10 pi = 31.4
  CHECK(sides_of_circle(1, {0, 1e-9, 1e-9}) == 629);  // $fs is at least 0.01
  CHECK(sides_of_circle(1e9, {0, 0, 0}) == 36'000);   // $fa as well
  CHECK(sides_of_circle(1, {0, infinity, infinity}) == 5);
  CHECK(sides_of_circle(10, {1}) == 3);
  CHECK(sides_of_circle(10, {4}) == 4);
  CHECK(sides_of_circle(10, {100}) == 100);
  CHECK(sides_of_circle(10, {6.5}) == 7);
  CHECK(sides_of_circle(10, {-5}) == 30);
  CHECK(sides_of_circle(10, {infinity}) == 3);
  CHECK(sides_of_circle(10, {std::nan("")}) == 3);
  CHECK(sides_of_circle(10, {1e300}) == 1U << 31);
  CHECK(sides_of_circle(9e-7, {100}) == 3);
  CHECK(sides_of_circle(0.00000095367431640625, {100}) == 100);
}

TEST_CASE("directions are exact where they can be, and symmetric", "[openscad]") {
  const double half_root = std::sqrt(0.5), long_root = std::sqrt(0.75);
  const double cosines[] = {1, long_root, half_root, 0.5, 0, -0.5, -half_root, -long_root, -1};
  const double angles[] = {0, 30, 45, 60, 90, 120, 135, 150, 180};
  for (int i = 0; i < 9; ++i) {
    CHECK(cosine_sine(angles[i]).cosine == cosines[i]);
    CHECK_FALSE(std::signbit(cosine_sine(90).cosine));
    if (i > 0 && i < 8) CHECK(cosine_sine(360 - angles[i]).cosine == cosines[i]);
  }
  CHECK(cosine_sine(30).sine == 0.5);
  CHECK(cosine_sine(180).sine == 0);
  CHECK(cosine_sine(270).sine == -1);
  for (double angle = 0.25; angle < 90; angle += 0.25) {
    const CosineSine d = cosine_sine(angle);
    CHECK(d.cosine == Approx(std::cos(angle * 3.141592653589793 / 180)));
    CHECK(d.sine == cosine_sine(90 - angle).cosine);
    CHECK(cosine_sine(180 - angle).cosine == -d.cosine);
    CHECK(cosine_sine(180 + angle).sine == -d.sine);
    CHECK(cosine_sine(360 - angle).cosine == d.cosine);
    CHECK(cosine_sine(90 + angle).sine == d.cosine);
  }
}

TEST_CASE("spheres have half as many rings as sides, and no poles", "[openscad]") {
  CHECK(corners_of("sphere(r = 10);") == 30 * 15);
  CHECK(corners_of("sphere(10, $fn = 3);") == 3 * 2);
  CHECK(corners_of("sphere($fn = 7, d = 4);") == 7 * 4);
  CHECK(mesh_of("sphere(r = 10);").triangles.size() == 2 * 450 - 4);
  const auto octahedron_like = solid_of("sphere(r = 2, $fn = 4);").bounding_box();
  CHECK(octahedron_like.upper == Vertex{2 * std::sqrt(0.5), 2 * std::sqrt(0.5), 2 * std::sqrt(0.5)});
  const auto box = solid_of("sphere(r = 10, $fn = 6);").bounding_box();  // rings at 30, 90 and 150 degrees
  CHECK(box.upper == Vertex{10, 10 * std::sqrt(0.75), 10 * std::sqrt(0.75)});
  CHECK(box.lower == Vertex{-10, -10 * std::sqrt(0.75), -10 * std::sqrt(0.75)});
  CHECK(solid_of("sphere(d = 4, r = 9, $fn = 6);") == solid_of("sphere(2, $fn = 6);"));
  CHECK(solid_of("sphere();") == solid_of("sphere(r = 1, $fn = 5);"));
}

TEST_CASE("cylinders, cones and what they are short for", "[openscad]") {
  CHECK(volume_of("cylinder(h = 3, r1 = 1, r2 = 1, $fn = 4);") == 6);
  CHECK(volume_of("cylinder(h = 3, r1 = 1, r2 = 0, $fn = 4);") == 2);
  CHECK(volume_of("cylinder(h = 3, r1 = 0, r2 = 1, $fn = 4);") == 2);
  CHECK(volume_of("cylinder(h = 3, r1 = 2, r2 = 1, $fn = 4);") == 14);
  CHECK(corners_of("cylinder(h = 3, r1 = 5, r2 = 0);") == 17);
  CHECK(corners_of("cylinder(h = 3, r1 = 1, r2 = 5);") == 32);  // the larger radius decides
  CHECK(solid_of("cylinder(d = 4, $fn = 4);") == solid_of("cylinder(h = 1, r1 = 2, r2 = 2, $fn = 4);"));
  CHECK(solid_of("cylinder(r = 3, d2 = 4, $fn = 4);") == solid_of("cylinder(h = 1, r1 = 3, r2 = 2, $fn = 4);"));
  CHECK(solid_of("cylinder($fn = 8);") == solid_of("cylinder(h = 1, r1 = 1, r2 = 1, $fn = 8);"));
  const auto centred = solid_of("cylinder(h = 3, r = 2, center = true, $fn = 4);").bounding_box();
  CHECK(centred.lower == Vertex{-2, -2, -1.5});
  CHECK(centred.upper == Vertex{2, 2, 1.5});
  CHECK(solid_of("cube([1, 2, 3], center = true);").bounding_box().lower == Vertex{-0.5, -1, -1.5});
}

// Catches: triangles turned over, seams left open, quadrilaterals divided differently by neighbours, caps that overlap.
TEST_CASE("primitives are solids without degenerate triangles", "[openscad][property]") {
  check_solid("cube([1, 2e-300, 3e300]);");
  check_solid("cube(0.1, center = true);");
  for (const std::string sides : {"3", "4", "5", "6", "7", "8", "12", "29", "30", "97"}) {
    check_solid("sphere(r = 0.7, $fn = " + sides + ");");
    check_solid("cylinder(h = 1, r1 = 0.3, r2 = 0.3, $fn = " + sides + ");");
    check_solid("cylinder(h = 1, r1 = 0.3, r2 = 0.3000000001, $fn = " + sides + ");");
    check_solid("cylinder(h = 1, r1 = 0, r2 = 0.3, center = true, $fn = " + sides + ");");
    check_solid("cylinder(h = 1, r1 = 0.3, r2 = 0, $fn = " + sides + ");");
  }
  for (const std::string size : {"1e-280", "1e-9", "3.14159", "1e200"}) {
    check_solid("sphere(r = " + size + ", $fn = 11);");
    check_solid("cylinder(h = 1, r1 = " + size + ", r2 = 2, $fn = 11);");
    check_solid("cylinder(h = " + size + ", r1 = 1, r2 = 0.9999999999999999, $fn = 11);");
  }
  check_solid("cylinder(h = 4.94066e-324, r1 = 1, r2 = 2, $fn = 9);");
}

TEST_CASE("fine primitives are solids, too", "[openscad][slow]") {
  check_solid("sphere(r = 10, $fn = 500);");
  check_solid("cylinder(h = 1, r1 = 0.1, r2 = 0.7, $fn = 2000);");
}

TEST_CASE("circles that are too fine or too small are refused", "[openscad]") {
  CHECK(error_of("\nsphere(1, $fn = 1e6);") == "2:1: a sphere of 1000000 sides has too many corners: at most 10000000");
  CHECK(error_of("cylinder(1, 1, 1, $fn = 1e300);") ==
        "1:1: a cylinder of 2147483648 sides has too many corners: at most 10000000");
  CHECK(error_of("sphere(1e-300);") == "1:1: a radius below 1e-290 is too small for doubles");
  CHECK(error_of("cylinder(1, 1, 1e-300);") == "1:1: a radius below 1e-290 is too small for doubles");
}
