#include <catch2/catch.hpp>

#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

std::string header(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string triangle_header =
    header("ascii", "element vertex 3\n" + xyz + "element face 1\nproperty list uchar int vertex_indices\n");
const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

}  // namespace

TEST_CASE("PLY elements and properties that are not known are no obstacle, in any order", "[io][ply]") {
  const std::string text = header(
      "ascii",
      "comment odd\nobj_info odder\nelement edge 2\nproperty int a\nproperty list uchar float b\nelement face 1\n"
      "property uchar red\nproperty list short uint vertex_index\nproperty list uchar float uv\nelement none 7\n"
      "element vertex 3\nproperty double z\nproperty list uchar int rings\nproperty int8 y\nproperty float nx\n"
      "property uint16 x\n");
  const auto file =
      read_text(text + "1 2 0.5 nan\n3 0\n255 3 0 1 2 1 0.5\n0 0 0 nan 0\n0 1 9 0 nan 1\n0 2 8 9 1 0 0\n", Format::ply);
  CHECK(file.mesh == triangle);
}

TEST_CASE("Binary PLY is read in both byte orders with any scalar types", "[io][ply]") {
  const std::string rest =
      "element vertex 3\nproperty int16 x\nproperty uchar u\nproperty int8 y\nproperty uint8 z\n"
      "element face 1\nproperty list uint16 int8 vertex_indices\n";
  using namespace std::string_literals;
  const std::string little = "\0\0\7\0\0\1\0\7\0\0\0\0\7\1\0\3\0\0\1\2"s,
                    big = "\0\0\7\0\0\0\1\7\0\0\0\0\7\1\0\0\3\0\1\2"s;
  CHECK(read_text(header("binary_little_endian", rest) + little, Format::ply).mesh == triangle);
  CHECK(read_text(header("binary_big_endian", rest) + big, Format::ply).mesh == triangle);
}

TEST_CASE("A binary PLY header may end in CR LF or CR before data that looks like line ends", "[io][ply]") {
  const std::string rest = "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : header("binary_little_endian", rest)) text += c == '\n' ? end : std::string(1, c);
    CHECK(read_text(text + "\n\r\n", Format::ply).mesh.vertices == std::vector<Vertex>{{10, 13, 10}});
  }
}

TEST_CASE("Triangle strips of a PLY file alternate and start again at -1", "[io][ply]") {
  const std::string text =
      header("ascii", "element vertex 5\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n") +
      points + "1 1 0\n2 2 0\n8 0 1 2 3 -1 2 3 4\n";
  CHECK(read_text(text, Format::ply).mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}

TEST_CASE("Malformed PLY is refused with its line or byte", "[io][ply]") {
  const auto line = [](const std::string& text) { return refused_line(text, Format::ply); };
  CHECK(line("plx\n") == 1);
  CHECK(line("ply\nformat text 1.0\n") == 2);
  CHECK(line("ply\nformat ascii 1.0\nelement vertex -1\n") == 3);
  CHECK(line("ply\nformat ascii 1.0\nproperty float x\n") == 3);
  CHECK(line("ply\nformat ascii 1.0\nelement vertex 1\nproperty complex x\n") == 4);
  CHECK(line("ply\nformat ascii 1.0\nelement vertex 1\n") == 4);
  CHECK(line(triangle_header + points + "3 0 1 3\n") == 13);
  CHECK(line(triangle_header + points + "3 0 1 1.5\n") == 13);
  CHECK(line(triangle_header + points + "-3 0 1 2\n") == 13);
  CHECK(line(triangle_header + points + "3 0 1\n") == 14);
  CHECK(line(triangle_header + "0 0 nan\n") == 10);
  CHECK(refusal(header("ascii", "element vertex 4000000000\n" + xyz) + points, Format::ply).find("room for") !=
        std::string::npos);
  const std::string bytes = to_string(tetrahedron, Format::ply);
  CHECK(refusal(bytes.substr(0, bytes.size() - 1), Format::ply).find(": byte ") != std::string::npos);
  CHECK(refusal(bytes.substr(0, bytes.size() - 60), Format::ply).find(": byte ") != std::string::npos);
}

TEST_CASE("PLY vertices without coordinates are refused, whatever faces say of them", "[io][ply]") {
  // Catches readers that check indices against the header's count of vertices that they never read.
  for (const char* face : {"3 0 1 2\n", "4 0 1 2 3\n"}) {
    const std::string list = "element face 1\nproperty list uchar int vertex_indices\n";
    for (const std::string& vertices : {std::string("element vertex 4\n"), "element vertex 4\n" + xyz.substr(17)})
      CHECK(refusal(header("ascii", vertices + list) + face, Format::ply).find("a property x") != std::string::npos);
  }
}
