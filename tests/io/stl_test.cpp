#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/io/binary.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {
const std::string facet =
    "facet normal nan nan nan\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
}

TEST_CASE("ASCII STL is read in any case and spacing, several solids as one mesh", "[io][stl]") {
  const std::string text =
      "  SOLID a name\r\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0\nvertex 0 1 0 endloop "
      "endfacet endsolid a name\nsolid\n" +
      facet + "endsolid\n";
  const auto file = read_text(text, Format::stl);
  CHECK(file.mesh == Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}});
}

TEST_CASE("A binary STL may start with the word solid", "[io][stl]") {
  std::string bytes = to_string(tetrahedron, Format::stl);
  for (const char* header : {"solid", "solid facet normal 0 0 0\nfacet", "solid\nfacet"}) {
    bytes.replace(0, std::string(header).size(), header);
    CHECK(read_text(bytes, Format::stl).mesh.triangles.size() == 4);
  }
}

TEST_CASE("STL corners become one vertex exactly when their coordinates are equal", "[io][stl]") {
  const auto next = std::nextafter(1.0, 2.0);
  const Mesh mesh{{{0.0, 1, 0}, {-0.0, 1, 0}, {next, 0, 0}, {1, 0, 0}, {5, 5, 5}}, {{0, 2, 4}, {1, 4, 3}}};
  const auto back = read_text(to_string(mesh, Format::stl_ascii), Format::stl).mesh;
  CHECK(back == Mesh{{{0, 1, 0}, {next, 0, 0}, {5, 5, 5}, {1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

TEST_CASE("Many STL corners are welded in the order of first use", "[io][stl]") {
  // Enough to make the hash table grow, with all triangles apart.
  Mesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    mesh.vertices.push_back({double(i % 10), double(i / 10 % 10), double(i / 100)});
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  CHECK(read_text(to_string(mesh, Format::stl), Format::stl).mesh == mesh);
}

TEST_CASE("Binary STL rounds doubles to floats and says so; ASCII STL keeps them", "[io][stl]") {
  Mesh mesh = tetrahedron;
  mesh.vertices[1][0] = 0.1;
  std::ostringstream stream;
  const auto notes = write_mesh(stream, mesh, Format::stl);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("1 of 4 vertices were rounded") == 0);
  CHECK(read_text(stream.str(), Format::stl).mesh.vertices[2][0] == static_cast<double>(0.1F));
  CHECK(read_text(to_string(mesh, Format::stl_ascii), Format::stl).mesh.vertices[2][0] == 0.1);
  mesh.vertices[1][0] = 1e39;
  CHECK_THROWS_AS(to_string(mesh, Format::stl), IoError);
  CHECK_NOTHROW(to_string(mesh, Format::stl_ascii));
}

TEST_CASE("Truncated and malformed STL is refused with its line or byte", "[io][stl]") {
  CHECK(refused_line("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", Format::stl) == 4);
  CHECK(refused_line("solid\n" + facet + "bogus\n", Format::stl) == 9);
  CHECK(refused_line("solid\n" + facet, Format::stl) == 9);
  CHECK(refused_line("solid\n" + facet.substr(0, 60), Format::stl) > 1);
  std::string bytes = to_string(tetrahedron, Format::stl);
  CHECK(refusal(bytes.substr(0, bytes.size() - 1), Format::stl).find("byte 80") != std::string::npos);
  CHECK(refusal(bytes.substr(0, 70), Format::stl) != "");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  io::store(bytes.data() + 84 + 50 + 12 + 4, nan, std::endian::little);
  CHECK(refusal(bytes, Format::stl) ==
        "test: byte 146: expected finite coordinates in corner 0 of triangle 1 (counted from 0)");
}

TEST_CASE("Bytes behind the last triangle of a binary STL are noted", "[io][stl]") {
  const auto file = read_text(to_string(tetrahedron, Format::stl) + "tail", Format::stl);
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(file.notes.size() == 1);
}
