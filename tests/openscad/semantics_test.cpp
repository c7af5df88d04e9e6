#include <catch2/catch.hpp>

#include "openscad/csg_text.h"
#include "support/shapes.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;

namespace {

std::string shifted(const std::string& by, const std::string& what) {
  return "multmatrix([[1,0,0," + by + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" + what + "}";
}

/// Names of the primitives that count.
std::string names_of(const std::string& text) {
  std::string names;
  for (const auto& p : read_csg(text, "test.csg").expression.primitives()) names += p.name + " ";
  return names;
}

}  // namespace

TEST_CASE("nodes at the top and in groups are united", "[openscad]") {
  CHECK(volume_of("cube(1);" + shifted("2", "cube(1);")) == 2);
  CHECK(volume_of("union() { cube(1);" + shifted("0.5", "cube(1);") + "}") == Rational(3, 2));
  CHECK(volume_of("group() { cube(1); cube(2); }") == 8);
  CHECK(volume_of(shifted("1", "cube(1);" + shifted("5", "cube(1);"))) == 2);
}

TEST_CASE("differences and intersections are those of all children", "[openscad]") {
  CHECK(volume_of("difference() { cube([4,1,1]);" + shifted("1", "cube(1);") + shifted("3", "cube(1);") + "}") == 2);
  CHECK(volume_of("intersection() { cube(4);" + shifted("1", "cube(4);") + "cube([9,1,1]); }") == 3);
  CHECK(volume_of("intersection() { cube(4); }") == 64);
  CHECK(volume_of("difference() { cube(4); }") == 64);
  CHECK(volume_of("difference() { union() { cube(1); cube([3,1,1]); } group() { cube(2); } }") == 1);
}

TEST_CASE("what is empty is empty", "[openscad]") {
  for (const char* text : {"", "union();", "union() {}", "group() { union(); }", "difference();", "intersection() {}",
                           "multmatrix();", "difference() { cube(0); cube(1); }", "difference() { group(); cube(1); }",
                           "intersection() { cube(1); cube(0); }", "intersection() { cube(1); group(); }",
                           "intersection() { union() {} cube(1); }", "polyhedron(points = [], faces = []);"}) {
    CAPTURE(text);
    CHECK(solid_of(text).is_empty());
  }
  CHECK(volume_of("difference() { cube(1); group(); cube(0); }") == 1);
  CHECK(volume_of("union() { cube(0); cube(1); group(); }") == 1);
}

TEST_CASE("primitives without volume make nothing, and a note", "[openscad]") {
  for (const char* text :
       {"cube(0);", "cube([1,0,1]);", "cube([1,-1,1], center=true);", "cube(inf);", "cube([1,1,nan]);",
        "cube([1,1,4.94066e-324], center=true);", "sphere(r=0);", "sphere(r=-1);", "sphere(r=inf);", "sphere(r=nan);",
        "cylinder(h=0, r1=1, r2=1);", "cylinder(h=-1, r1=1, r2=1);", "cylinder(h=1, r1=0, r2=0);",
        "cylinder(h=1, r1=-1, r2=1);", "cylinder(h=1, r1=1, r2=-1);", "cylinder(h=inf, r1=1, r2=1);",
        "cylinder(h=1, r1=-inf, r2=1);", "polyhedron(points = [[0,0,0]], faces = []);", "polyhedron();"}) {
    CAPTURE(text);
    CHECK(solid_of(text).is_empty());
    CHECK_THAT(notes_of(text), Contains("makes nothing (line 1)"));
  }
  CHECK(notes_of("cube(0);\ncube(0);\nsphere(-1);") ==
        "a cube without volume makes nothing (2 times, first in line 1)\n"
        "a sphere without volume makes nothing (line 3)\n");
}

TEST_CASE("modifiers drop, keep and single out parts", "[openscad]") {
  CHECK(volume_of("cube(1); %cube(2); *cube(3); #cube([1,1,2]);") == 2);
  CHECK(volume_of("difference() { %cube(9); cube(2); *cube(1); %cube(1); }") == 8);
  CHECK(volume_of("intersection() { cube(2); %cube(1); *group(); }") == 8);
  CHECK(volume_of("% # group() { cube(1); }") == 0);
  CHECK(volume_of(shifted("5", "cube(3); ! cube(2); *!cube(7); !cube(8);") + "cube(4);") == 8);
  CHECK(solid_of(shifted("5", "!cube(2);")) == solid_of("cube(2);"));  // transforms above do not count
  CHECK(volume_of("%group() { !%difference() { cube(2); *cube(1); } } cube(5);") == 8);
  CHECK(volume_of("*group() { !cube(2); } cube(1);") == 1);
  CHECK(notes_of("%cube(1);\n%cube(1);\n*cube(1);") ==
        "a part marked % is left out (2 times, first in line 1)\na part marked * is left out (line 3)\n");
  CHECK(notes_of("%!cube(1);") == "only the part marked ! counts (line 1)\n");
  CHECK(notes_of("cube(1);\n!cube(2);\n!cube(3);") ==
        "only the part marked ! counts (line 2)\nanother part is marked !, but the first one counts (line 3)\n");
}

TEST_CASE("render is passed over, with one note", "[openscad]") {
  CHECK(volume_of("render(convexity = 2) { cube(1); render() cube(2); }") == 8);
  CHECK(notes_of("render(convexity = 2) {\nrender() { cube(2); } }") ==
        "render is passed over (2 times, first in line 1)\n");
  CHECK(volume_of("intersection() { cube(1); render(); }") == 0);
}

TEST_CASE("what is not supported is refused by name, at its place, where it counts", "[openscad]") {
  for (const std::string name : {"roof", "translate", "rotate", "for", "if", "echo", "Cube"}) {
    CAPTURE(name);
    const std::string error = error_of("cube(1);\nunion() {\n  " + name + "(1, a = \"b\") { cube(1); }\n}");
    CHECK_THAT(error, Catch::StartsWith("3:3: " + name + " is n"));
    CHECK(volume_of("%" + name + "(); cube(1);") == 1);
    CHECK(volume_of(name + "() { !cube(1); }") == 1);
  }
  CHECK(error_of("cube(1) {\n cube(2); }") == "2:2: nothing can be in a cube");
}

TEST_CASE("matrices place, mirror and flatten", "[openscad]") {
  CHECK(solid_of("multmatrix([[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(1); }") ==
        Solid(box({-1, 0, 0}, {0, 1, 1})));
  CHECK(solid_of("multmatrix([[0,-1,0,0],[1,0,0,0],[0,0,1,5]]) { cube([1,2,3]); }") ==
        Solid(box({-2, 0, 5}, {0, 1, 8})));
  CHECK(volume_of("multmatrix([[1],[0,1],[0,0,1],[0,0,0,2]]) { cube(4); }") == 8);
  CHECK(volume_of("multmatrix(m = [[2]]) { cube(1); }") == 2);
  CHECK(volume_of("multmatrix([[1,0.5],[0,1]]) { cube(1); }") == 1);
  CHECK(volume_of("difference() { cube(2); multmatrix([[-1,0,0,1]]) { cube(1); } }") == 7);
  for (const char* matrix : {"[[0]]", "[[1,1],[1,1]]", "[[1,0,0,inf]]", "[[nan]]", "[[1],[],[],[0,0,0,0]]"}) {
    CAPTURE(matrix);
    const std::string text = "multmatrix(" + std::string(matrix) + ") { cube(2); } cube(1);";
    CHECK(volume_of(text) == 1);
    CHECK_THAT(notes_of(text), Contains("makes nothing (line 1)"));
  }
}

TEST_CASE("matrices are multiplied exactly before any coordinate is touched", "[openscad]") {
  const std::string thirds = "multmatrix([[3]]) { multmatrix([[0.1]]) { cube([10, 1, 1]); } }";
  CHECK(volume_of(thirds) == 30 * to_rational(0.1));
  const CsgModel rounded = read_csg(thirds, "test.csg", Placement::rounded);
  CHECK(rounded.expression.evaluate().exact_mesh().exact.empty());
  CHECK_FALSE(read_csg(thirds, "test.csg").expression.evaluate().exact_mesh().exact.empty());
}

TEST_CASE("primitives are called after their lines, and equal ones are one solid", "[openscad]") {
  CHECK(names_of("cube(1);\nsphere(1);\n  cube(2); cube(3);") == "cube_1 sphere_2 cube_3 cube_3_12 ");
  CHECK(names_of("cube(1);\ncube(size = [1, 1, 1], center = false);\n" + shifted("2", "cube(1);")) == "cube_1 cube_3 ");
  CHECK(read_csg("difference() { cube(3);\nsphere(1);\ncube(1); }", "").expression.text() ==
        "cube_1 - sphere_2 - cube_3");
}
