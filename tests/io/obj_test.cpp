#include <catch2/catch.hpp>
#include <cmath>

#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {
MeshFile read_obj(std::string_view text) { return read_text(text, Format::obj); }
const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
}  // namespace

TEST_CASE("OBJ corners may carry texture and normal indices, which are ignored", "[io][obj]") {
  for (const char* face : {"f 1 2 3", "f 1/9 2/9 3/9", "f 1//9 2//9 3//9", "f 1/8/9 2/8/9 3/8/9", "f -3 -2 -1",
                           "f +1 +2 +3", "f 1/-1/-2 2/1 3//4", "f 1/ 2/ 3/"}) {
    CAPTURE(face);
    CHECK(read_obj(corners + face).mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
  }
}

TEST_CASE("Relative OBJ indices count from the vertices read so far, absolute ones may point ahead", "[io][obj]") {
  const auto file = read_obj("f 1 2 4\n" + corners + "f -3 -2 -1\nv 0 0 1\nf -1 -2 -3\n");
  CHECK(file.mesh.triangles == std::vector<Triangle>{{0, 1, 3}, {0, 1, 2}, {3, 2, 1}});
}

TEST_CASE("OBJ lines may be indented, continued, commented and end in any way", "[io][obj]") {
  const auto file = read_obj(
      "\xEF\xBB\xBF# head \\\r\n  v 0 0 0 # origin\r\n\tv 1 \\\r\n 0 0\rv 0 1 0 1.0\nv 0 0 1 0.5 nan red\n"
      "o thing\ng a b\ns 1\nusemtl x\\\ny\nmtllib z.mtl\nf 1 2 \\\n  3\n\n\nf 2 3 4");
  CHECK(file.mesh.vertices == std::vector<Vertex>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(file.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}});
  CHECK(file.notes.empty());
}

TEST_CASE("Lines, points and free-form geometry in an OBJ are counted in notes", "[io][obj]") {
  const auto notes =
      all_notes(read_obj(corners + "l 1 2\np 1\np 2\ncurv 0 1 1 2\nsurf 0 1 0 1 1\nqq 1\nf 1 2 3\n").notes);
  CHECK(notes.find("1 line statements") != std::string::npos);
  CHECK(notes.find("2 point statements") != std::string::npos);
  CHECK(notes.find("2 free-form") != std::string::npos);
  CHECK(notes.find("1 unknown statements") != std::string::npos);
}

TEST_CASE("Malformed OBJ is refused with its line", "[io][obj]") {
  CHECK(refused_line("v 0 0\n", Format::obj) == 1);
  CHECK(refused_line("v 0 0 0\nv 0 0x 0\n", Format::obj) == 2);
  CHECK(refused_line("v 0 0 0\r\n\r\nv 0 nan 0\n", Format::obj) == 3);
  CHECK(refused_line("v 0 0 0\rv 0 0 1.#IND\r", Format::obj) == 2);
  CHECK(refused_line("v 0 0 -inf\n", Format::obj) == 1);
  CHECK(refused_line("v 0 0 1e999\n", Format::obj) == 1);
  CHECK(refused_line(corners + "f 1 2 0\n", Format::obj) == 4);
  CHECK(refused_line(corners + "f 1 2 3\nf 1 2 4\n", Format::obj) == 5);
  CHECK(refused_line(corners + "f 1 2 -4\n", Format::obj) == 4);
  CHECK(refused_line(corners + "f 1 2 3a\n", Format::obj) == 4);
  CHECK(refused_line(corners + "f 1/2/3/4 2 3\n", Format::obj) == 4);
  CHECK(refused_line(corners + "f 1 2 99999999999999999999\n", Format::obj) == 4);
  CHECK(refused_line("\x89PNG\r\nrubbish\n", Format::obj) == 1);
  CHECK(refusal(corners + "f 1 2 4\n", Format::obj) ==
        "test:4: vertex index 4 is out of range: the file has 3 vertices");
}

TEST_CASE("Numbers are read to the nearest double, below the range as zero", "[io][obj]") {
  const auto v =
      read_obj("v 0.1 +.5 5.\nv 1e-400 -0.00001e-999999999999999999999 4.9e-324\nv 1E5 -0 1.7976931348623157e308")
          .mesh.vertices;
  CHECK(v == std::vector<Vertex>{{0.1, 0.5, 5}, {0, 0, 4.9e-324}, {1e5, 0, 1.7976931348623157e308}});
  CHECK(std::signbit(v[1][1]));
}

TEST_CASE("Faces with fewer than three different vertices are left out and noted", "[io][obj]") {
  const auto file = read_obj(corners + "v 1 1 0\nf 1 2\nf 1 2 3\nf 1 1 2\nf 1 2 1 2\nf 1 1 2 4 4 3 1\n");
  CHECK(file.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {0, 3, 2}});
  CHECK(file.polygon_of_triangle == std::vector<std::uint32_t>{1, 4, 4});
  CHECK(file.notes ==
        std::vector<std::string>{"3 faces with fewer than three different vertices left out; the first is "
                                 "face 0 (counted from 0)"});
}
