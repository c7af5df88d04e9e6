#include <catch2/catch.hpp>
#include <cmath>

#include "openscad/csg_text.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;

namespace {

planar::Region shape_of(const std::string& text) {
  const CsgModel model = read_csg(text, "test.csg");
  CHECK(model.expression.evaluate().is_empty());
  return model.shape.value_or(planar::Region());
}

Rational area_of(const std::string& text) { return planar::area(shape_of(text)); }

double nearest_area_of(const std::string& text) { return to_nearest_double(area_of(text)); }

/// A square hole in a square.
const std::string frame = "difference() { square(4, center = true); square(2, center = true); }";

std::string moved(const std::string& x, const std::string& y, const std::string& what) {
  return "multmatrix([[1,0,0," + x + "],[0,1,0," + y + "],[0,0,1,7],[0,0,0,1]]) {" + what + "}";
}

}  // namespace

TEST_CASE("squares, circles and polygons have OpenSCAD's corners", "[openscad]") {
  CHECK(area_of("square([2, 3]);") == 6);
  CHECK(area_of("square(2, center = true);") == 4);
  CHECK(planar::canonical_form(shape_of("square(2, center = true);"))[0][0] == planar::RationalPlacement{-1, -1});
  CHECK(area_of("circle(r = 1, $fn = 4);") == 2);
  CHECK(area_of("circle(d = 4, $fn = 4);") == 8);
  CHECK(shape_of("circle(r = 10);").loops.vertices.size() == 30);
  CHECK(area_of("polygon(points = [[0,0],[4,0],[0,4]]);") == 8);
  CHECK(area_of("polygon(points = [[0,0],[0,4],[4,0]], paths = undef);") == 8);  // clockwise
  CHECK(area_of("polygon(points = [[0,0],[4,0],[4,4],[0,4]], paths = [[0,1,2]]);") == 8);
  CHECK(area_of("polygon(points = [[0,0],[4,0],[0,4],[9,9]], paths = [0,1,2]);") == 8);
}

TEST_CASE("paths of polygons are filled by parity, whatever their directions", "[openscad]") {
  const std::string points = "polygon(points = [[0,0],[4,0],[4,4],[0,4],[1,1],[3,1],[3,3],[1,3]], paths = ";
  CHECK(area_of(points + "[[0,1,2,3],[4,5,6,7]]);") == 12);
  CHECK(area_of(points + "[[0,1,2,3],[7,6,5,4]]);") == 12);
  CHECK(area_of(points + "[[4,5,6,7],[4,5,6,7],[0,1,2,3]]);") == 16);
  CHECK(area_of("polygon(points = [[0,0],[2,2],[2,0],[0,2]]);") == 2);  // crosses itself
}

TEST_CASE("shapes without area make nothing, and a note", "[openscad]") {
  for (const char* text :
       {"square(0);", "square([1,-1]);", "square(inf);", "circle(0);", "circle(r = -1);", "circle(nan);",
        "polygon(points = [[0,0],[1,1],[2,2]]);", "polygon(points = [], paths = [[]]);"}) {
    CAPTURE(text);
    CHECK(shape_of(text).empty());
    CHECK_THAT(notes_of(text), Contains("makes nothing (line 1)"));
  }
  CHECK_THAT(error_of("polygon(points = [[0,0,0]]);"), Contains("no two finite numbers at number 0"));
  CHECK_THAT(error_of("polygon(points = [[0,0],[1,0],[0,1]], paths = [[0,1,3]]);"), Contains("there are 3"));
  CHECK_THAT(error_of("circle(1, $fn = 20000000);"), Contains("too many corners"));
}

TEST_CASE("shapes are united, intersected and subtracted exactly", "[openscad]") {
  CHECK(area_of("square(2); " + moved("1", "1", "square(2);")) == 7);
  CHECK(area_of("intersection() { square(2); " + moved("1", "1", "square(2);") + "}") == 1);
  CHECK(area_of(frame) == 12);
  CHECK(area_of("difference() { square(0); square(2); }") == 0);
  CHECK(area_of("intersection() { square(2); group(); }") == 0);
  // A third is no double: exact all the same.
  CHECK(area_of("intersection() { polygon(points = [[0,0],[3,1],[3,9],[0,9]]); square(1); }") == Rational(5, 6));
}

TEST_CASE("matrices move shapes within the plane", "[openscad]") {
  CHECK(area_of("multmatrix([[-2,0,0,5],[0,3,0,1],[0,0,0,9],[0,0,0,1]]) { square(1); }") == 6);  // flat in space
  CHECK(area_of("multmatrix([[0.1]]) { multmatrix([[10]]) { square(1); } }") == to_rational(0.1) * 10);
  const std::string text = "multmatrix([[1,0],[0,0,1],[0,1]]) { square(1); }";  // stood up
  CHECK(shape_of(text).empty());
  CHECK_THAT(notes_of(text), Contains("without inverse makes nothing"));
}

TEST_CASE("the first part decides between shapes and solids", "[openscad]") {
  CHECK(area_of("square(2); cube(9);") == 4);
  CHECK_THAT(notes_of("square(2); cube(9);"), Contains("a solid among shapes is passed over"));
  CHECK(volume_of("group(); cube(2); square(9);") == 8);
  CHECK_THAT(notes_of("cube(2); square(9);"), Contains("a shape among solids is passed over"));
  CHECK(volume_of("intersection() { cube(2); square(1); cube(1); }") == 0);
}

TEST_CASE("hulls of shapes are exact", "[openscad]") {
  CHECK(area_of("hull() { square(1); " + moved("3", "0", "square(1);") + "}") == 4);
  CHECK(area_of("hull() { " + frame + "}") == 16);
  CHECK(area_of("hull() { group(); square(0); }") == 0);
}

// Catches: sums of convex parts where parts are not convex; holes that are lost, or kept where they close.
TEST_CASE("Minkowski sums of shapes are exact, holes included", "[openscad]") {
  const std::string unit = "square(1, center = true);",
                    notch = "polygon(points = [[0,0],[2,0],[2,2],[1,2],[1,1],[0,1]]);";
  CHECK(area_of("minkowski() { square([2,3]); square([4,5]); }") == 48);
  CHECK(area_of("minkowski() { " + frame + unit + "}") == 25 - 1);
  CHECK(area_of("minkowski() { " + unit + frame + "}") == 25 - 1);
  CHECK(area_of("minkowski() { " + frame + "square(2, center = true); }") == 36);  // the hole closes
  CHECK(area_of("minkowski() { " + notch + unit + "}") == 9 - 1);
  CHECK(area_of("minkowski() { " + notch + "polygon(points = [[0,0],[1,0],[0.25,0.25],[0,1]]); }") ==
        area_of("minkowski() { polygon(points = [[0,0],[1,0],[0.25,0.25],[0,1]]); " + notch + "}"));
  CHECK(area_of("minkowski() { " + frame + frame + "}") == 64);  // covers both holes
  CHECK(area_of("minkowski() { square(3); group(); }") == 0);
  CHECK(area_of("minkowski() { square(3); }") == 9);
  CHECK(area_of("minkowski() { group() {" + frame + moved("9", "0", "square(1);") + "}" + unit + "}") == 24 + 4);
}

TEST_CASE("offsets move edges and join corners", "[openscad]") {
  CHECK(area_of("offset(delta = 1) { square(2); }") == 16);
  CHECK(area_of("offset(delta = -0.5) { square(2); }") == 1);
  CHECK(area_of("offset(delta = -1) { square(2); }") == 0);
  CHECK(area_of("offset(delta = -3) { square(2); }") == 0);
  CHECK(area_of("offset(r = 0) { square(2); }") == 4);
  CHECK(area_of("offset(r = 1, $fn = 4) { square(2); }") == Rational(4 + 8 + 2));
  CHECK(area_of("offset(r = -0.5) { square(2); }") == 1);
  CHECK(nearest_area_of("offset(r = 1, $fn = 360) { square(2); }") == Approx(12 + 3.14159).epsilon(1e-4));
  CHECK(nearest_area_of("offset(delta = 1, chamfer = true) { square(2); }") ==
        Approx(16 - 4 * std::pow(2 - std::sqrt(2), 2) / 1).epsilon(0.05));
  CHECK(area_of("offset(delta = 0.5) { " + frame + "}") == 24);
  CHECK(area_of("offset(delta = 1) { " + frame + "}") == 36);
  CHECK(area_of("offset(delta = -1) { " + frame + "}") == 0);
  CHECK(area_of("offset(r = 5) { group(); }") == 0);
  CHECK_THAT(error_of("offset(r = inf) { square(1); }"), Contains("is not finite"));
}

TEST_CASE("fill closes holes", "[openscad]") {
  CHECK(area_of("fill() { " + frame + "}") == 16);
  CHECK(area_of("fill();") == 0);
}

TEST_CASE("projections are sections at zero, or shadows", "[openscad]") {
  CHECK(area_of("projection(cut = false) { cube([2,3,4]); }") == 6);
  CHECK(area_of("projection() { multmatrix([[1,0,1],[0,1],[0,0,1]]) { cube(1); } }") == 2);
  CHECK(area_of("projection() { difference() { cube(4); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,-1]]) { cube([1,1,9]); "
                "} } }") == 15);
  // Several layers, one above a hole of another, which touches itself in a vertex.
  const std::string plate =
      "difference() { cube([6,6,1]); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,-1]]) { cube([2,2,9]); } "
      "multmatrix([[1,0,0,3],[0,1,0,3],[0,0,1,-1]]) { cube([2,2,9]); } }";
  CHECK(area_of("projection() { " + plate + " }") == 28);
  CHECK(area_of("projection() { " + plate + " multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,5]]) { cube([1,1,1]); } }") == 29);
  CHECK(area_of("projection() { cube(2); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,5]]) { cube(2); } "
                "multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,9]]) { cube(1); } }") == 7);
  CHECK(area_of("projection(cut = true) { cube(2, center = true); }") == 4);
  CHECK(area_of("projection(cut = true) { cube(2); }") == 4);  // touches the plane from above
  CHECK(area_of("projection(cut = true) { multmatrix([[1],[0,1],[0,0,1,-2]]) { cube(2); } }") == 4);  // and from below
  CHECK(area_of("projection(cut = true) { multmatrix([[1],[0,1],[0,0,1,1]]) { cube(2); } }") == 0);
}

TEST_CASE("a section that only touches the solid from above has its coordinates", "[openscad]") {
  const auto corner = [](const std::string& text) { return planar::canonical_form(shape_of(text)); };
  const std::string shape = "polygon(points = [[1,2],[6,2],[1,4]]);";
  CHECK(corner("projection(cut = true) { multmatrix([[1],[0,1],[0,0,1,-2]]) { linear_extrude(height = 2) { " + shape +
               " } } }") == corner(shape));
}

TEST_CASE("what several nodes take the value of is the same as for each alone", "[openscad]") {
  const std::string body =
      "multmatrix([[0.6,-0.8,0.1],[0.8,0.6],[0,0.1,1]]) { difference() { sphere(r = 9, $fn = 12); "
      "cylinder(r = 3, h = 40, center = true, $fn = 9); } }";
  const auto at = [&](int z) { return "multmatrix([[1],[0,1],[0,0,1," + std::to_string(z) + "]]) { " + body + " }"; };
  const auto cut = [&](int z) {  // maps that do not commute
    return "projection(cut = true) { multmatrix([[1,0,0.5],[0,2],[0.5,0,1]]) { " + at(z) + " } }";
  };
  std::string shapes = "group() { ";
  Rational areas = 0;
  for (int z = -4; z <= 4; ++z) {
    shapes += "multmatrix([[1,0,0," + std::to_string(30 * z) + "],[0,1]]) { " + cut(z) + " } ";
    areas += area_of(cut(z));
  }
  CHECK(areas > 0);
  CHECK(area_of(shapes + "}") == areas);
  const std::string sized = "resize(newsize = [3,4,5]) { " + body + " }";
  CHECK(volume_of(sized + "multmatrix([[1,0,0,99],[0,1],[0,0,1]]) { " + sized + at(0) + " }") ==
        2 * volume_of(sized) + volume_of(body));
  // The part itself is beyond all doubles; what becomes of it is not.
  const auto scaled = [](const std::string& by, const std::string& what) {
    return "multmatrix([[" + by + "],[0," + by + "],[0,0," + by + "]]) { " + what + " }";
  };
  const auto small = [&](const std::string& by) {
    return "projection(cut = false) { " + scaled(by, scaled("1e300", "cube(1e10);")) + " }";
  };
  CHECK(area_of(small("1e-300") + small("2e-300")) == area_of(small("2e-300")));
  // Where vertices are rounded in their places, the value of what is moved is not known.
  const auto rounded_area = [&](const std::string& text) {
    return planar::area(read_csg(text, "test.csg", Placement::rounded).shape.value_or(planar::Region()));
  };
  const std::string beside = "multmatrix([[1,0,0,60],[0,1]]) { " + cut(2) + " }";
  CHECK(rounded_area(cut(1) + beside) == rounded_area(cut(1)) + rounded_area(beside));
}

TEST_CASE("resize scales to sizes, exactly", "[openscad]") {
  CHECK(area_of("resize(newsize = [3,1,0]) { square([7,9]); }") == 3);
  CHECK(area_of("resize(newsize = [3,0,0]) { square([7,9]); }") == 27);
  CHECK(area_of("resize(newsize = [14,0,0], auto = [0,1,0]) { square([7,9]); }") == 14 * 18);
  CHECK(volume_of("resize(newsize = [1,2,3]) { cube([7,9,11]); }") == 6);
  CHECK(volume_of("resize(newsize = [0,0,22], auto = true) { cube([7,9,11]); }") == 7 * 9 * 11 * 8);
  CHECK(volume_of("resize(newsize = [5,5,5]) { group(); }") == 0);
}

TEST_CASE("drawings in DXF hold the loops", "[openscad]") {
  const std::string dxf = to_dxf(shape_of(frame));
  CHECK_THAT(dxf, Contains("AC1009") && Catch::EndsWith("EOF\n"));
  std::size_t polylines = 0;
  for (std::size_t at = dxf.find("POLYLINE"); at != std::string::npos; at = dxf.find("POLYLINE", at + 1)) ++polylines;
  CHECK(polylines == 2);
}
