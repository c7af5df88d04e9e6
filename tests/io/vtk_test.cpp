// VTK: the bytes of a small mesh with channels, as the format's description has them.
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "attributed.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

MeshFile triangle_with_channels() {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}}};
  file.attributes.channels = {
      {"two words", Element::vertex, Interpolation::linear, 2, std::vector<float>{0, 0.5, 1, 1.5, 2, 2.5}},
      {"region", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{-7}},
      {"color", Element::face, Interpolation::linear, 3, std::vector<std::uint8_t>{1, 2, 255}},
      {"seam", Element::corner, Interpolation::linear, 1, std::vector<double>{1, 2, 3}}};
  return file;
}

}  // namespace

TEST_CASE("VTK text has points, polygons, and channels of faces and vertices", "[io][vtk]") {
  CHECK(written(triangle_with_channels(), Format::vtk_ascii) ==
        "# vtk DataFile Version 3.0\nstrata\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0\n1 0 0\n0 0.5 0\n"
        "POLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nSCALARS region int 1\nLOOKUP_TABLE default\n-7\n"
        "SCALARS color unsigned_char 3\nLOOKUP_TABLE default\n1 2 255\n"
        "POINT_DATA 3\nSCALARS two_words float 2\nLOOKUP_TABLE default\n0 0.5\n1 1.5\n2 2.5\n");
}

TEST_CASE("Binary VTK has the same numbers, big end first", "[io][vtk]") {
  const std::string bytes = written(triangle_with_channels(), Format::vtk);
  const auto behind = [&](const std::string& line) {
    const std::size_t at = bytes.find(line);
    REQUIRE(at != std::string::npos);
    return bytes.substr(at + line.size());
  };
  using namespace std::string_literals;
  CHECK(behind("POINTS 3 double\n").substr(24, 8) == "\x3f\xf0\0\0\0\0\0\0"s);
  CHECK(behind("POLYGONS 1 4\n").substr(0, 17) == "\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\n"s);
  CHECK(behind("region int 1\nLOOKUP_TABLE default\n").substr(0, 5) == "\xff\xff\xff\xf9\n"s);
  CHECK(behind("unsigned_char 3\nLOOKUP_TABLE default\n").substr(0, 4) == "\1\2\xff\n"s);
  CHECK(behind("float 2\nLOOKUP_TABLE default\n").substr(4, 4) == "\x3f\0\0\0"s);
}

TEST_CASE("VTK tells what it cannot keep, and is not read", "[io][vtk]") {
  MeshFile file = triangle_with_channels();
  file.attributes.objects = {"part"};
  WriteOptions options;
  options.format = Format::vtk;
  options.attributes = &file.attributes;
  options.unit = Unit::inch;
  std::ostringstream stream;
  CHECK(write_mesh(stream, ExactMesh{file.mesh, {}}, options) ==
        std::vector<std::string>{"channel seam left out: VTK cannot keep it",
                                 "names of objects left out: VTK cannot keep them",
                                 "the unit (inch) left out: VTK cannot keep it"});
  CHECK(refusal(stream.str(), Format::vtk).find("can be written, but not be read") != std::string::npos);
  CHECK(to_string(Mesh{}, Format::vtk_ascii) ==
        "# vtk DataFile Version 3.0\nstrata\nASCII\nDATASET POLYDATA\nPOINTS 0 double\nPOLYGONS 0 0\n");
}
