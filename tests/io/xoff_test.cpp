// The lossless format: what its numbers and faces mean, and that hostile files are refused with their line.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <sstream>

#include "strata/measure.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

MeshFile read(const std::string& text) { return read_text(text, Format::xoff); }

std::uint64_t line(const std::string& text) { return refused_line(text, Format::xoff); }

std::string why(const std::string& text) { return refusal(text, Format::xoff); }

ExactMesh exact_mesh(const MeshFile& file) { return {file.mesh, file.exact}; }

/// A file with one vertex, whose first coordinate is the number.
MeshFile read_number(const std::string& number) { return read("XOFF\n1 0 0\n" + number + " 1 2\n"); }

Rational number_of(const std::string& text) { return exact_mesh(read_number(text)).position(0)[0]; }

/// Twice the area that the triangles cover in the plane z = 0.
Rational double_area(const ExactMesh& mesh) {
  Rational sum = 0;
  for (const Triangle& t : mesh.mesh.triangles) {
    const RationalPoint a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    const Rational own = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    CHECK(own > 0);
    sum += own;
  }
  return sum;
}

const std::string square = "0 0 0\n6 0 0\n6 6 0\n0 6 0\n";
const std::string inner = "1 1 0\n1 2 0\n2 2 0\n2 1 0\n";

}  // namespace

TEST_CASE("Numbers in XOFF are exact, but decimals with a point or an exponent are doubles as in OFF", "[io][xoff]") {
  CHECK(number_of("7") == 7);
  CHECK(number_of("-12") == -12);
  CHECK(number_of("1/3") == Rational(1, 3));
  CHECK(number_of("-4/6") == Rational(-2, 3));
  CHECK(number_of("+010/08") == Rational(5, 4));
  CHECK(number_of("0.1") == to_rational(0.1));
  CHECK(number_of("1e22") == to_rational(1e22));
  CHECK(number_of("1e-400") == 0);
  CHECK(number_of("9007199254740993") == Rational(Integer("9007199254740993")));  // 2^53 + 1, which is no double
  CHECK(number_of("9007199254740993.0") == to_rational(9007199254740992.0));
  CHECK(read_number("1/3").exact.size() == 1);
  CHECK(read_number("1/3").mesh.vertices[0][0] == 1.0 / 3);
  CHECK(read_number("3/4").exact.empty());
  CHECK(read_number("18014398509481984").exact.empty());  // 2^54
  CHECK(std::signbit(read_number("-0").mesh.vertices[0][0]));
}

TEST_CASE("Numbers of hundreds and of many thousands of digits are read and written", "[io][xoff]") {
  const std::string long_digits = "7" + std::string(400, '3'), longer(200'000, '9');
  CHECK(number_of(long_digits + "/" + long_digits + "1") ==
        Rational(Integer(long_digits.c_str()), Integer((long_digits + "1").c_str())));
  const MeshFile file = read("XOFF\n1 0 0\n" + longer + "/8" + longer + " 1/3 2\n");
  const std::string once = to_string(exact_mesh(file), Format::xoff);
  CHECK(to_string(exact_mesh(read(once)), Format::xoff) == once);
  CHECK(exact_mesh(read(once)).position(0) == exact_mesh(file).position(0));
  CHECK(number_of("1/" + longer) > 0);
  CHECK(read_number("1/" + longer).mesh.vertices[0][0] == 0);
}

TEST_CASE("Exact vertices are written in lowest terms, doubles as in OFF", "[io][xoff]") {
  const MeshFile file = read("XOFF # lossless\n3 1 0\n2/6 0.1 -0\n1 18014398509481985 1e300\n-5/2 3 4/8\n3 0 1 2\n");
  CHECK(to_string(exact_mesh(file), Format::xoff) ==
        "XOFF\n3 1 0\n1/3 0.1 -0\n1 18014398509481985 1e+300\n-2.5 3 0.5\n3 0 1 2\n");
  REQUIRE(file.exact.size() == 2);
  CHECK(file.exact[0].vertex == 0);
  CHECK(file.exact[1].vertex == 1);
  CHECK(file.polygon_of_triangle.empty());
}

TEST_CASE("Other formats get the rounded doubles of exact vertices", "[io][xoff]") {
  const ExactMesh mesh = exact_mesh(read("XOFF\n3 1 0\n1/3 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  for (const Format format : {Format::obj, Format::off, Format::ply, Format::stl_ascii})
    CHECK(to_string(mesh, format) == to_string(mesh.mesh, format));
  std::ostringstream stream;
  write_mesh(stream, mesh, Format::xoff);
  CHECK(stream.str() == to_string(mesh, Format::xoff));
  CHECK(format_of("a.XOFF") == Format::xoff);
  CHECK(format_named("xoff") == Format::xoff);
}

TEST_CASE("Exact places that no reader would take back are not written", "[io][xoff]") {
  ExactMesh mesh{tetrahedron, {}};
  const Rational third(1, 3);
  mesh.exact = {{2, {third, third, third}}, {1, {third, third, third}}};
  CHECK_THROWS_AS(to_string(mesh, Format::xoff), IoError);
  mesh.exact = {{4, {third, third, third}}};
  CHECK_THROWS_AS(to_string(mesh, Format::xoff), IoError);
  mesh.exact = {{1, {Rational(Integer(1) << 1024), third, third}}};
  CHECK_THROWS_AS(to_string(mesh, Format::xoff), IoError);
  mesh.exact = {{1, {third, third, third}}};
  CHECK_NOTHROW(to_string(mesh, Format::xoff));
}

TEST_CASE("Polygons become triangles that know their face", "[io][xoff]") {
  const MeshFile file = read("XOFF\n8 3 12\n" + square + inner + "3 0 1 2\n4 0 1 2 3 + 4 4 5 6 7\n3 0 2 3\n");
  CHECK(file.mesh.vertices.size() == 8);
  CHECK(file.mesh.triangles.size() == 10);
  CHECK(file.polygon_of_triangle == std::vector<std::uint32_t>{0, 1, 1, 1, 1, 1, 1, 1, 1, 2});
  const ExactMesh mesh = exact_mesh(file);
  CHECK(double_area(mesh) == 2 * (36 + 36 - 1));
}

TEST_CASE("A cube with a rational square tunnel, in eight faces", "[io][xoff]") {
  std::string text = "XOFF # block of side 3 with a tunnel of side 1/3\n16 10 0\n";
  for (const char* z : {"0", "3"}) {
    for (const char* p : {"0 0", "3 0", "3 3", "0 3", "4/3 4/3", "5/3 4/3", "5/3 5/3", "4/3 5/3"})
      text += std::string(p) + " " + z + "\n";
  }
  text += "4 3 2 1 0 + 4 4 5 6 7\n4 8 9 10 11 + 4 15 14 13 12\n";
  text += "4 0 1 9 8\n4 1 2 10 9\n4 2 3 11 10\n4 3 0 8 11\n";
  text += "4 5 4 12 13\n4 6 5 13 14\n4 7 6 14 15\n4 4 7 15 12\n";
  const MeshFile file = read(text);
  CHECK(topology(exact_mesh(file)).open_edges == 0);
  CHECK(topology(exact_mesh(file)).euler == 0);
  CHECK(volume(exact_mesh(file)) == 27 - Rational(1, 3));
}

TEST_CASE("Holes that touch the loop and each other keep all corners", "[io][xoff]") {
  // A hole from corner 0, another one that touches it in vertex 6, and a vertex on a straight stretch.
  const MeshFile file =
      read("XOFF\n10 1 0\n" + square + "1 2 0\n2 1 0\n2 2 0\n2 3 0\n3 2 0\n3 0 0\n5 0 9 1 2 3 + 4 0 4 6 5 + 3 6 7 8\n");
  CHECK(double_area(exact_mesh(file)) == 2 * 36 - 2 * 2 - 1);
  for (std::uint32_t v = 0; v < 10; ++v) {
    CAPTURE(v);
    CHECK(std::any_of(file.mesh.triangles.begin(), file.mesh.triangles.end(),
                      [&](const Triangle& t) { return t[0] == v || t[1] == v || t[2] == v; }));
  }
}

TEST_CASE("Triangles are taken as they are; those without three vertices are left out", "[io][xoff]") {
  const MeshFile file = read("XOFF\n4 3 0\n" + square + "3 0 1 2\n3 0 0 1\n3 0 2 3\n");
  CHECK(file.mesh.triangles.size() == 2);
  CHECK(file.polygon_of_triangle == std::vector<std::uint32_t>{0, 2});
  CHECK(all_notes(file.notes).find("left out; the first is face 1") != std::string::npos);
}

TEST_CASE("Malformed XOFF is refused with its line", "[io][xoff]") {
  CHECK(line("OFF\n4 0 0\n" + square) == 1);
  CHECK(line("XOFF4 0 0\n" + square) == 1);
  CHECK(line("XOFF\n4 0\n" + square) == 3);  // a coordinate is taken for the edges
  CHECK(line("XOFF\n-4 0 0\n") == 2);
  CHECK(line("XOFF\n4 1 0 0\n") == 2);
  CHECK(line("XOFF\n4/1 1 0\n") == 2);
  CHECK(line("XOFF\n2 0 0\n0 0 0\n0 0\n0 0 0\n") == 4);
  CHECK(line("XOFF\n2 0 0\n0 0 0 1\n0 0 0\n") == 3);
  for (const char* bad : {"1/0", "1/-3", "-1/+3", "1/",    "/3", "1//3", "1/3/4", "1.5/2", "1/2e3", "0x10", "1/0x10",
                          "--1", "nan",  "inf",   "1e400", "x",  "1/00", "1 /3",  "-",     "-/2",   "1,5"}) {
    CAPTURE(bad);
    CHECK(line("XOFF\n2 0 0\n0 0 0\n0 " + std::string(bad) + " 0\n") == 4);
  }
  const std::string huge(310, '9');
  CHECK(line("XOFF\n1 0 0\n0 " + huge + " 0\n") == 3);
  CHECK(line("XOFF\n1 0 0\n0 " + huge + "/7 0\n") == 3);
  CHECK(line("XOFF\n1 0 0\n0 " + huge + "/7" + huge + " 0\n") == 0);
  CHECK(why("XOFF\n1 0 0\n0 1/0 0\n").find("denominator that is not zero, found '1/0'") != std::string::npos);
  CHECK(why("XOFF\n1 0 0\n0 " + huge + "/7 0\n").find("within the range of doubles") != std::string::npos);
}

TEST_CASE("Faces of XOFF that are wrong are refused with their line", "[io][xoff]") {
  const auto face_line = [](const std::string& face) {
    return line("XOFF\n8 2 0\n" + square + "0 0 1/3\n" + "6 0 1/3\n0 6 1\n1 1 0\n3 0 1 2\n" + face + "\n");
  };
  for (const char* bad : {"3 0 1 8",
                          "3 0 1 -1",
                          "3 0 1",
                          "2 0 1",
                          "0",
                          "1 0",
                          "-3 0 1 2",
                          "4 0 1 2",
                          "3 0 1 2 3",
                          "3 0 1 2 4 0 1 2",
                          "4 0 1 2 3 + 3 0 1",
                          "4 0 1 2 3 +",
                          "4 0 1 2 3 + 2 0 1",
                          "4 0 1 2 3 +3 0 1 2",
                          "3.0 0 1 2",
                          "3 0 1 1/1",
                          "99999999999999999999 0 1 2",
                          "400000000 0 1 2",
                          "4 0 1 4 3",
                          "4 0 1 3 2",
                          "4 0 1 2 3 + 3 0 1 7",
                          "4 0 0 1 2"}) {
    CAPTURE(bad);
    CHECK(face_line(bad) == 12);
  }
  CHECK(face_line("4 0 1 2 3 # a square") == 0);
  const std::string bent = "XOFF\n5 2 0\n" + square + "6 6 1/1000000000000000000000000000000000000000000000\n";
  CHECK(why(bent + "3 0 1 2\n4 0 1 4 3\n")
            .find("test:9: face 1 (counted from 0) has corners that are not in one plane") != std::string::npos);
  CHECK(line(bent + "3 0 1 4\n3 0 4 3\n") == 0);
}

TEST_CASE("Counts of XOFF that lie are refused, and quickly", "[io][xoff]") {
  CHECK(why("XOFF\n1000000000 1 0\n0 0 0\n").find("room for") != std::string::npos);
  CHECK(why("XOFF\n1 4000000000 0\n0 0 0\n").find("room for") != std::string::npos);
  CHECK(why("XOFF\n3 1 0\n" + square + "1000000000 0 1\n").find("room for") == std::string::npos);
  CHECK(line("XOFF\n4 1 0\n" + square + "1000000000 0 1 2\n") == 7);
  CHECK(line("XOFF\n4 1 0\n" + square + "3 0 1 2\n3 0 2 3\n") == 8);  // more than promised
  CHECK(line("XOFF\n4 2 0\n" + square + "3 0 1 2\n\n") != 0);         // fewer
  CHECK(line("XOFF\n5 1 0\n" + square + "3 0 1 2\n") == 7);           // the face is taken for a vertex
}

TEST_CASE("Blank lines, comments and line ends of all kinds are passed over in XOFF", "[io][xoff]") {
  CHECK(read("\n# c\nXOFF\n\n3\n1 # d\n7\n\n 1/3 0 0 # e\n\n1 0 0\r\n0\t1 0\r3 0 1 2").exact.size() == 1);
}
