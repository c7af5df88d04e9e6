#include <catch2/catch.hpp>

#include "openscad/csg_text.h"
#include "support/shapes.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

const std::string cube_points = "points = [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]], ";

}  // namespace

TEST_CASE("faces of polyhedra are clockwise as seen from outside", "[openscad]") {
  CHECK(solid_of("polyhedron(" + cube_points +
                 "faces = [[0,1,2,3],[4,5,1,0],[7,6,5,4],[5,6,2,1],[6,7,3,2],[7,4,0,3]], convexity = 1);") ==
        Solid(box({0, 0, 0}, {1, 1, 1})));
  // example011 of OpenSCAD
  CHECK(volume_of("polyhedron(points = [[10, 0, 0], [0, 10, 0], [-10, 0, 0], [0, -10, 0], [0, 0, 10]], "
                  "faces = [[0, 1, 2, 3], [4, 1, 0], [4, 2, 1], [4, 3, 2], [4, 0, 3]]);") == Rational(2000, 3));
  const std::string turned = error_of("\n polyhedron(" + cube_points +
                                      "faces = [[3,2,1,0],[0,1,5,4],[4,5,6,7],[1,2,6,5],[2,3,7,6],[3,0,4,7]]);");
  CHECK_THAT(turned, StartsWith("2:2: the polyhedron bounds no solid: inside-out; "));
  CHECK_THAT(turned, Contains("clockwise"));
}

TEST_CASE("faces that are not convex are divided exactly", "[openscad]") {
  // an arrow head, extruded
  const std::string arrow =
      "polyhedron(points = [[0,0,0],[4,0,0],[1,1,0],[0,4,0],[0,0,1],[4,0,1],[1,1,1],[0,4,1]], "
      "faces = [[0,1,2,3],[7,6,5,4],[4,5,1,0],[5,6,2,1],[6,7,3,2],[7,4,0,3]], convexity = 2);";
  CHECK(volume_of(arrow) == 4);
  CHECK(notes_of(arrow).empty());
}

TEST_CASE("faces that are not planar are divided in a fixed way, with a note", "[openscad]") {
  const std::string bent =
      "polyhedron(points = [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,2],[0,1,1]], "
      "faces = [[0,1,2,3],[4,5,1,0],[7,6,5,4],[5,6,2,1],[6,7,3,2],[7,4,0,3]]);";
  CHECK_THAT(notes_of(bent), StartsWith("polyhedron: 1 polygon not planar in doubles"));
  CHECK_THAT(notes_of(bent), Contains("face 2 (counted from 0) (line 1)"));
  const Rational volume = volume_of(bent);
  CHECK((volume == Rational(4, 3) || volume == Rational(7, 6)));
}

TEST_CASE("faces with fewer than three corners are left out, with a note", "[openscad]") {
  const std::string text =
      "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = "
      "[[0,1,2],[0,3,1],[],[0,2,3],[1,3,2],[0,1],[2,2,1]]);";
  CHECK(volume_of(text) == Rational(1, 6));
  CHECK_THAT(notes_of(text),
             Contains("3 faces with fewer than three different vertices left out; the first is face 2"));
}

TEST_CASE("polyhedra that bound no solid are refused with a defect", "[openscad]") {
  CHECK_THAT(error_of("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3]]);"),
             StartsWith("1:1: the polyhedron bounds no solid: open edge at "));
  // two tetrahedra that cross; the quadrilateral before them moves the numbers of triangles
  const std::string crossing = error_of(
      "polyhedron(points = [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[.5,.5,1],[0,0,.5],[4,0,.5],[0,4,.5],[0,0,4]], "
      "faces = [[0,1,2,3],[4,1,0],[4,2,1],[4,3,2],[4,0,3],[5,6,7],[5,8,6],[5,7,8],[6,8,7]]);");
  CHECK_THAT(crossing, StartsWith("1:1: the polyhedron bounds no solid: self-intersection at "));
  CHECK_THAT(crossing, Contains(" and 5"));
}

TEST_CASE("points and faces that are none are errors with their numbers", "[openscad]") {
  CHECK(error_of("polyhedron(points = [[0,0,0],[0,0]], faces = []);") ==
        "1:12: the points of polyhedron have no three finite numbers at number 1");
  CHECK_THAT(error_of("polyhedron([[0,0,inf]], []);"), Contains("at number 0"));
  CHECK_THAT(error_of("polyhedron([[0,0,true]], []);"), Contains("at number 0"));
  CHECK_THAT(error_of("polyhedron(3, []);"), Contains("the points of polyhedron are no vector"));
  CHECK_THAT(error_of("polyhedron([[0,0,0]], [0]);"), Contains("the faces of polyhedron have no vector at number 0"));
  for (const std::string corner : {"1", "-1", "0.5", "nan", "true", "1e300"}) {
    CAPTURE(corner);
    CHECK_THAT(error_of("polyhedron([[0,0,0]], [[0,0,0],[0," + corner + ",0]]);"),
               Contains("a corner at number 1 that is no number of a point: there are 1"));
  }
}
