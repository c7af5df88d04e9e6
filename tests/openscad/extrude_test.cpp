#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "openscad/csg_text.h"
#include "strata/check.h"
#include "strata/measure.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;

namespace {

double nearest_volume_of(const std::string& text) { return to_nearest_double(volume_of(text)); }

const std::string frame = "difference() { square(4, center = true); square(2, center = true); }";

std::string at(const std::string& x, const std::string& what) {
  return "multmatrix([[1,0,0," + x + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" + what + "}";
}

}  // namespace

TEST_CASE("linear extrusions are prisms", "[openscad]") {
  CHECK(volume_of("linear_extrude(height = 5) { square([2,3]); }") == 30);
  CHECK(volume_of("linear_extrude() { square(1); }") == 100);
  CHECK(volume_of("linear_extrude(height = 2) { " + frame + "}") == 24);
  CHECK(volume_of("linear_extrude(height = 0) { square(1); }") == 0);
  CHECK(volume_of("linear_extrude(height = -3) { square(1); }") == 0);
  CHECK(volume_of("linear_extrude(height = 3);") == 0);
  CHECK(volume_of("linear_extrude(height = 3) { cube(1); }") == 0);
  CHECK(solid_of("linear_extrude(height = 2, center = true) { square(2, center = true); }") ==
        solid_of("cube(2, center = true);"));
  CHECK(volume_of("linear_extrude(height = 2, v = [1, 0, 0.5]) { square(1); }") > 0);
  // Parts that touch in a corner, and a vertex that is no double.
  CHECK(volume_of("linear_extrude(height = 2) { square(1); multmatrix([[1,0,0,1],[0,1,0,1]]) { square(1); } }") == 4);
  CHECK(volume_of("linear_extrude(height = 3) { intersection() { polygon(points = [[0,0],[3,1],[3,9],[0,9]]); "
                  "square(1); } }") == Rational(5, 2));
}

TEST_CASE("linear extrusions taper exactly, to ridges and points", "[openscad]") {
  CHECK(volume_of("linear_extrude(height = 3, scale = 0) { square(2, center = true); }") == 4);
  CHECK(volume_of("linear_extrude(height = 3, scale = 0.5) { square(2, center = true); }") == 7);
  CHECK(volume_of("linear_extrude(height = 3, scale = [0, 1], slices = 1) { square(2, center = true); }") == 6);
  CHECK(volume_of("linear_extrude(height = 3, scale = [0, 1]) { square(2, center = true); }") == 6);
  CHECK(volume_of("linear_extrude(height = 3, scale = [1, 0], $fn = 7) { square(2, center = true); }") == 6);
  CHECK(volume_of("linear_extrude(height = 3, scale = 0) { " + frame + "}") == 12);
  CHECK(volume_of("linear_extrude(height = 3, scale = 2) { square(1); }") == 7);
  CHECK(volume_of("linear_extrude(height = 3, scale = -1) { square(2, center = true); }") == 4);  // as 0
  const Solid ridge = solid_of("linear_extrude(height = 3, scale = [0, 1]) { circle(r = 2, $fn = 9); }");
  CHECK(is_embedded(ExactMeshView(ridge.exact_mesh())));
  CHECK(ridge.volume() > 0);
}

TEST_CASE("twisted extrusions keep their sections", "[openscad]") {
  // Volumes are those of OpenSCAD 2021.01.
  const auto volume = [](const std::string& arguments, const std::string& shape) {
    return nearest_volume_of("linear_extrude(height = 4, " + arguments + ") { " + shape + "}");
  };
  const std::string corner = "square([2, 5]);";
  CHECK(volume("twist = 90, slices = 4", "square(2, center = true);") == Approx(17.634945633).epsilon(1e-5));
  CHECK(volume("twist = -90, slices = 4", "square(2, center = true);") == Approx(17.634945633).epsilon(1e-5));
  CHECK(volume("twist = 90", corner) == Approx(45.32173398).epsilon(1e-5));
  CHECK(volume("twist = 90, scale = 0.5", corner) == Approx(23.336552).epsilon(1e-5));
  CHECK(volume("twist = 90, scale = [0.5, 2]", corner) == Approx(44.485692).epsilon(1e-5));
  CHECK(volume("scale = [0.5, 2]", corner) == Approx(43.333333333).epsilon(1e-9));
  CHECK(volume("twist = 720, scale = 0", corner) == Approx(12.8663418763).epsilon(1e-5));
  CHECK(volume("twist = 90, slices = 400", "square(2, center = true);") == Approx(16).epsilon(2e-3));
  CHECK(volume("twist = 200, $fn = 50", "difference() { circle(5, $fn = 50); square(3, center = true); }") ==
        Approx(275.939616754).epsilon(1e-5));
  CHECK(volume("twist = 90, segments = 8, slices = 6", corner) < volume("twist = 90, slices = 6", corner));
}

// Catches: apexes with several vertices, layers that are left open, faces that cross and are kept.
TEST_CASE("extrusions twisted twice round with scale 0 are solids", "[openscad]") {
  for (const char* text : {"linear_extrude(height = 10, twist = 720, scale = 0) { square(4, center = true); }",
                           "linear_extrude(height = 10, twist = 720, scale = 0, slices = 3) { square([4,1]); }",
                           "linear_extrude(height = 10, twist = -720, scale = [0, 1]) { square(4, center = true); }",
                           "linear_extrude(height = 10, twist = 720, slices = 2) { square([5, 1]); }",
                           "linear_extrude(height = 10, twist = 360, slices = 2, segments = 0) { square([5, 1]); }"}) {
    CAPTURE(text);
    const Solid solid = solid_of(text);
    CHECK(is_embedded(ExactMeshView(solid.exact_mesh())));
    CHECK(solid.volume() > 0);
    CHECK(solid.volume() < 160);
  }
  CHECK_THAT(error_of("linear_extrude(height = 1, twist = 90, slices = 900000) { circle(1, $fn = 100); }"),
             Contains("ten million corners"));
}

TEST_CASE("rotations of profiles are rings", "[openscad]") {
  const std::string profile = at("2", "square(1);");
  CHECK(nearest_volume_of("rotate_extrude($fn = 4) { " + profile + "}") == Approx(2 * 9 - 2 * 4));
  CHECK(nearest_volume_of("rotate_extrude(angle = 180, $fn = 4) { " + profile + "}") == Approx(5));
  CHECK(nearest_volume_of("rotate_extrude(angle = -90, $fn = 4) { " + profile + "}") == Approx(2.5));
  CHECK(nearest_volume_of("rotate_extrude(angle = 360, start = 180, $fn = 4) { " + at("-3", "square(1);") + "}") ==
        Approx(10));
  CHECK(nearest_volume_of("rotate_extrude(angle = 720, $fn = 4) { " + profile + "}") == Approx(10));
  CHECK(volume_of("rotate_extrude(angle = 0) { " + profile + "}") == 0);
  CHECK(volume_of("rotate_extrude();") == 0);
  CHECK_THAT(notes_of("rotate_extrude() { square(2, center = true); }"), Contains("both sides of the axis"));
  CHECK(topology(solid_of("rotate_extrude() { " + profile + "}").exact_mesh()).euler == 0);
}

// Catches: faces of edges on the axis, axis points with a vertex per step.
TEST_CASE("profiles may touch the axis in corners and along edges", "[openscad]") {
  CHECK(nearest_volume_of("rotate_extrude($fn = 4) { square([1, 3]); }") == Approx(6));
  CHECK(nearest_volume_of("rotate_extrude($fn = 4) { polygon(points = [[0,0],[1,0],[1,1]]); }") == Approx(2 - 2.0 / 3));
  CHECK(nearest_volume_of("rotate_extrude(angle = 90, $fn = 4) { square([1, 3]); }") == Approx(1.5));
  for (const char* profile : {"polygon(points = [[0,1],[1,0],[1,2]]);",                        // one corner
                              "polygon(points = [[0,0],[1,0],[1,3],[0,3],[0.5,2],[0,1.5]]);",  // two edges
                              "circle(r = 1, $fn = 3); "}) {
    CAPTURE(profile);
    const bool crosses = std::string(profile).starts_with("circle");
    const Solid solid = solid_of(std::string("rotate_extrude() { ") + profile + "}");
    CHECK(solid.is_empty() == crosses);
    CHECK(is_embedded(ExactMeshView(solid.exact_mesh())));
  }
}

TEST_CASE("hulls of solids are exact, also of unions that are never evaluated", "[openscad]") {
  CHECK(volume_of("hull() { cube(1); " + at("3", "cube(1);") + "}") == 4);
  CHECK(volume_of("hull() { difference() { cube(4); cube(3); } }") == 64 - Rational(27, 6));
  CHECK(volume_of("hull() { group(); cube(0); }") == 0);
  CHECK(volume_of("hull() { cube(1); group(); square(8); }") == 1);
  CHECK(volume_of("hull() { multmatrix([[3]]) { multmatrix([[0.1]]) { cube([10,1,1]); } } }") == 30 * to_rational(0.1));
}

TEST_CASE("Minkowski sums of solids are exact", "[openscad]") {
  CHECK(volume_of("minkowski() { cube(1); cube(2); }") == 27);
  CHECK(volume_of("minkowski() { difference() { cube(3, center = true); cube([1,1,9], center = true); } cube(1, center "
                  "= true); }") == 64);
  CHECK(volume_of("minkowski() { cube(2); group(); cube(0); }") == 8);
  CHECK(volume_of("minkowski() { intersection() { cube(1); " + at("5", "cube(1);") + "} cube(3); }") == 27);
  CHECK(volume_of("minkowski();") == 0);
  CHECK(volume_of("minkowski() { cube(1); cube(1); cube(1); }") == 27);
}

TEST_CASE("equal subtrees are evaluated once", "[openscad]") {
  const std::string part = "hull() { cube(1); multmatrix([[1,0,0,2]]) { sphere(1); } }";
  const CsgModel model = read_csg(part + "\n" + at("9", part) + "\n" + at("18", "group() { " + part + "}"), "test.csg");
  REQUIRE(model.nodes.size() == 1);
  CHECK(model.nodes[0].name == "hull");
  CHECK(model.nodes[0].line == 1);
  CHECK(model.expression.evaluate().components().size() == 3);
}

// Catches: recursion, and what grows faster than the number of nodes.
TEST_CASE("nodes may be nested ten thousand deep", "[openscad]") {
  std::string text, end;
  for (int i = 0; i < 9998; ++i) {
    text += i % 2 == 0 ? "difference() {" : "group() {";
    end += "}";
  }
  CHECK(volume_of(text + "cube(2);" + end) == 8);
  CHECK(planar::area(*read_csg(text + "square(3);" + end, "test.csg").shape) == 9);
  std::string chain = "cube(2);", tail;
  std::string front;
  for (int i = 0; i < 2000; ++i) {
    front += "difference() { ";
    tail += " cube(1); }";
  }
  CHECK(volume_of(front + chain + tail) == 7);
}
