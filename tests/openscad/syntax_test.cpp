#include <algorithm>
#include <catch2/catch.hpp>

#include "openscad/csg_text.h"
#include "strata/errors.h"
#include "support/random.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("white space, comments, empty statements and commas at ends are passed over", "[openscad]") {
  CHECK(volume_of("cube(size=[1,2,3],center=false);") == 6);
  CHECK(volume_of("\xEF\xBB\xBF\tcube ( size = [ 1 , 2 , 3 , ] , ) ; // cube(9)\r\n") == 6);
  CHECK(volume_of("/* cube(9);\n*/ ;; union() { ; cube(2); /**/ } //") == 8);
  CHECK(volume_of("") == 0);
  CHECK(volume_of("union() group() { cube(2); } cube(1);") == 8);  // one child without braces
  CHECK(volume_of("union() group() cube(2); difference() { cube(1); cube(1); }") == 8);
  CHECK(volume_of("difference() cube(2); cube([1,1,3]);") == 9);
}

TEST_CASE("numbers are the doubles nearest to the decimals", "[openscad]") {
  CHECK(volume_of("cube(2e0);") == 8);
  CHECK(volume_of("cube(20E-1);") == 8);
  CHECK(volume_of("cube(.5);") == Rational(1, 8));
  CHECK(volume_of("cube(2.);") == 8);
  CHECK(volume_of("cube(+2);") == 8);
  CHECK(volume_of("cube(--2);") == 8);
  const Rational tenth = to_rational(0.1);
  CHECK(volume_of("cube([0.1,1,1]);") == tenth);
  CHECK(error_of("cube(1.2.3);") == "1:6: '1.2.3' is no number");
  CHECK(error_of("cube(12mm);") == "1:6: '12mm' is no number");
  CHECK(error_of("cube(1e);") == "1:6: '1e' is no number");
  CHECK(error_of("cube(1e999);") == "1:6: the number 1e999 is beyond the range of doubles");
  CHECK_THAT(error_of("cube(-true);"), Contains("a sign without a number"));
  CHECK_THAT(error_of("cube(-);"), Contains("expected a number"));
}

TEST_CASE("strings end where their escapes have it", "[openscad]") {
  CHECK(volume_of(R"(color("red") { cube(2); })") == 8);
  CHECK(volume_of(R"(color("\"red\\") { cube(2); })") == 8);
  CHECK(volume_of("color(\"a\nb); cube(9);\") { cube(2); }") == 8);
  CHECK(error_of("\ncolor(\"red) { cube(2); }") == "2:7: a string is never closed");
  CHECK(error_of(R"(color("\")") == "1:7: a string is never closed");
}

TEST_CASE("errors of syntax have a file, a line and a column", "[openscad]") {
  CHECK_THROWS_WITH(read_csg("cube(1);\n  cube(1;", "part.csg"), "part.csg:2:9: expected ',' or ')', found ';'");
  CHECK(error_of("cube(1)") == "1:8: expected ';' or '{', found the end of the file");
  CHECK(error_of("union() {\n  cube(1);\n") == "1:9: a '{' is never closed");
  CHECK(error_of("cube(1); }") == "1:10: a '}' without a '{'");
  CHECK(error_of("union() }") == "1:9: expected ';' or '{', found '}'");
  CHECK(error_of("cube;") == "1:5: expected '(', found ';'");
  CHECK(error_of("# 5") == "1:3: expected a node such as 'union()', found '5'");
  CHECK(error_of("cube([1,2 3]);") == "1:11: expected ',' or ']', found '3'");
  CHECK(error_of("cube(size=);") == "1:11: expected a number, a vector, a string, true, false or undef, found ')'");
  CHECK(error_of("cube(x);") == "1:6: 'x' is no value: .csg files have no variables");
  CHECK(error_of("cube([x]);") == "1:7: 'x' is no value: .csg files have no variables");
  CHECK(error_of("/* cube(1);") == "1:1: a comment is never closed");
  CHECK(error_of("cube(1 / 2);") == "1:8: a '/' has no meaning here");
  CHECK(error_of("cube(\xff);") == "1:6: a character has no meaning here");
  CHECK(error_of("\r\n\r\n cube(?);") == "3:7: a '?' has no meaning here");
  CHECK(error_of("\r\r cube(?);") == "3:7: a '?' has no meaning here");
}

TEST_CASE("arguments are told by name or by position", "[openscad]") {
  CHECK(volume_of("cube([2,3,4], true);") == 24);
  CHECK(solid_of("cube(size=2, true);") == solid_of("cube(center=true, size=[2,2,2]);"));
  CHECK(volume_of("cube(1, size=3);") == 27);
  CHECK(volume_of("cube(size=1, size=3);") == 27);
  CHECK(volume_of("cube(undef);") == 1);
  CHECK(volume_of("cube(size=2, center=undef);") == 8);
  CHECK(solid_of("cylinder(3, 2, 1, true, $fn=4);") == solid_of("cylinder(h=3, r1=2, r2=1, center=true, $fn=4);"));
  CHECK(notes_of("cube(2, true, 7);") == "cube has too many arguments, which are passed over (line 1)\n");
  CHECK(notes_of("cube(2, centre=true);\ncube(3, centre=true);") ==
        "cube has no 'centre', which is passed over (2 times, first in line 1)\n");
  CHECK(notes_of("union(1);") == "union has too many arguments, which are passed over (line 1)\n");
  CHECK(notes_of("cube(2, $t=0);").empty());
}

TEST_CASE("arguments of a wrong kind are errors with their places", "[openscad]") {
  CHECK(error_of("cube(size = true);") == "1:6: the size of cube is neither a number nor three");
  CHECK_THAT(error_of("cube([1, 2]);"), StartsWith("1:6: the size of cube"));
  CHECK_THAT(error_of("cube([1, 2, undef]);"), StartsWith("1:6: the size of cube"));
  CHECK(error_of("cube(1,\n center = 1);") == "2:2: the center of cube is neither true nor false");
  CHECK(error_of("sphere(r = \"1\");") == "1:8: the r of sphere is no number");
  CHECK(error_of("sphere(r = 1, $fa = nan);") == "1:15: the $fa of sphere is no number");
  CHECK(error_of("sphere(r = 1, $fe = 0.1);") == "1:15: the $fe of sphere is not supported");
  CHECK_THAT(error_of("multmatrix([1]) { cube(1); }"), StartsWith("1:12: the m of multmatrix has a row"));
  CHECK_THAT(error_of("multmatrix([[1,0,0,0,0]]) { cube(1); }"), Contains("has a row"));
  CHECK_THAT(error_of("multmatrix([[true]]) { cube(1); }"), Contains("a coefficient that is no number"));
  CHECK_THAT(error_of("multmatrix(3) { cube(1); }"), Contains("no vector of up to four rows"));
  CHECK_THAT(error_of("multmatrix([[1],[0,1],[0,0,1],[1,0,0,1]]) { cube(1); }"), Contains("last row"));
}

TEST_CASE("what is deep is read without recursion, or refused", "[openscad]") {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "multmatrix() {";
    text += "cube(1);" + std::string(static_cast<std::size_t>(depth), '}');
    return text;
  };
  CHECK(volume_of(nested(9'999)) == 1);
  CHECK_THAT(error_of(nested(200'000)), Contains("nested more than 10000 deep"));
  std::string unbraced;
  for (int i = 0; i < 200'000; ++i) unbraced += "union()";
  CHECK_THAT(error_of(unbraced + "cube(1);"), Contains("nested more than 10000 deep"));
  CHECK_THAT(error_of("cube(" + std::string(200'000, '[')), StartsWith("1:23: vectors are nested too deeply"));
  CHECK(volume_of("cube(" + std::string(200'000, '-') + "1);") == 1);
  CHECK_THAT(error_of(std::string(200'000, '#')), Contains("expected a node"));
  CHECK_THAT(error_of(std::string(200'000, '{')), StartsWith("1:1: expected a node"));
}

TEST_CASE("long files are read", "[openscad]") {
  std::string text = "difference() {\ncube([200000, 1, 1]);\n";
  for (int i = 0; i < 20'000; ++i)
    text += "multmatrix([[1,0,0," + std::to_string(2 * i) + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(1); }\n";
  const CsgModel model = read_csg(text + "}", "test.csg");
  CHECK(model.expression.size() == 20'001);
  CHECK(model.notes.empty());
}

TEST_CASE("many different notes do not fill the memory", "[openscad]") {
  std::string text;
  for (int i = 0; i < 1'000; ++i) text += "cube(1, a" + std::to_string(i) + " = 1);\n";
  const auto notes = read_csg(text, "test.csg").notes;
  REQUIRE(notes.size() == 101);
  CHECK(notes.back() == "900 more notes are left out");
}

// Catches: reads beyond the end, loops without progress, exceptions of other kinds.
TEST_CASE("damaged files are read or refused", "[openscad][property]") {
  const std::string text =
      "difference() {\n\tmultmatrix([[1, 0, 0, -24], [0, 0.5, 0, 0], [0, 0, -1e0, 0], [0, 0, 0, 1]]) {\n"
      "\t\tcube(size = [15, 15, 15], center = true);\n#\t\tsphere($fn = 5, $fa = 12, $fs = 2, r = 10);\n\t}\n"
      "%\tcylinder($fn = 0, h = inf, r1 = 1, r2 = 0); /* \"a\\\"\" */\n\tcolor(\"red\") cube();\n"
      "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);\n}\n";
  const std::string marks = "()[]{}<>\"\\/*%#!;,=-+.e19$\n\r\t \xff";
  Random random(7);
  std::size_t refused = 0;
  for (int round = 0; round < 3'000; ++round) {
    std::string damaged = text;
    for (std::uint64_t k = random.below(3) + 1; k > 0; --k) {
      const auto at = static_cast<std::size_t>(random.below(damaged.size()));
      if (random.once_in(3)) damaged.erase(at, random.below(9));
      if (random.once_in(3)) damaged.insert(std::min(at, damaged.size()), 1, random.pick(marks));
      if (random.once_in(9)) damaged.resize(at + 1);
    }
    CAPTURE(damaged);
    try {
      (void)read_csg(damaged, "test.csg");
    } catch (const CsgError& e) {
      ++refused;
      REQUIRE(e.line() >= 1);
      REQUIRE(e.column() >= 1);
    }
  }
  CHECK(refused > 500);
}

TEST_CASE("a file that is not there is no .csg file", "[openscad]") {
  CHECK_THROWS_AS(read_csg_file("no/such/file.csg"), IoError);
}
