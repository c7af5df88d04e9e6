#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <sstream>

#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

constexpr Format exact_formats[] = {
    Format::obj, Format::off, Format::xoff, Format::ply, Format::ply_ascii, Format::ply_big_endian, Format::threemf};

/// Any finite doubles at all, subnormals and both zeros included.
Mesh random_mesh(unsigned seed) {
  std::mt19937_64 random(seed);
  Mesh mesh;
  while (mesh.vertices.size() < 9000) {
    Vertex p{};
    for (double& x : p) do
        x = std::bit_cast<double>(random());
      while (!std::isfinite(x));
    mesh.vertices.push_back(p);
  }
  mesh.vertices[0] = {0.0, -0.0, 5e-324};
  for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); ++i) mesh.triangles.push_back({i, i + 2, i + 1});
  return mesh;
}

bool same_bits(const Mesh& a, const Mesh& b) {
  return a == b &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), [](const Vertex& p, const Vertex& q) {
           return std::bit_cast<std::array<std::uint64_t, 3>>(p) == std::bit_cast<std::array<std::uint64_t, 3>>(q);
         });
}

}  // namespace

TEST_CASE("What is written in doubles is read back bit by bit", "[io][property]") {
  const Mesh mesh = random_mesh(1);
  for (const Format format : exact_formats) {
    CAPTURE(name(format));
    CHECK(same_bits(read_text(to_string(mesh, format), format).mesh, mesh));
  }
  const std::string once = to_string(mesh, Format::stl_ascii);
  const auto welded = read_text(once, Format::stl_ascii).mesh;
  CHECK(to_string(welded, Format::stl_ascii) == once);
}

TEST_CASE("An empty mesh survives every format", "[io]") {
  for (const Format format : {Format::obj, Format::off, Format::xoff, Format::ply, Format::ply_ascii,
                              Format::ply_big_endian, Format::stl, Format::stl_ascii}) {
    CAPTURE(name(format));
    const auto file = read_text(to_string(Mesh{}, format), format);
    CHECK(file.mesh == Mesh{});
    CHECK(file.notes == std::vector<std::string>{"the file holds no faces"});
  }
}

TEST_CASE("A mesh that no reader would take back is not written", "[io]") {
  Mesh mesh = tetrahedron;
  mesh.vertices[2][1] = std::nan("");
  CHECK_THROWS_AS(to_string(mesh, Format::obj), IoError);
  mesh = tetrahedron;
  mesh.triangles[1][2] = 4;
  CHECK_THROWS_AS(to_string(mesh, Format::off), IoError);
  CHECK_THROWS_AS(to_string(tetrahedron, Format::other), IoError);
}

TEST_CASE("Formats go by extension in any case, and by name", "[io]") {
  CHECK(format_of("a.STL") == Format::stl);
  CHECK(format_of("dir.obj/a.Ply") == Format::ply);
  CHECK(format_of("a") == Format::other);
  CHECK(format_of("a.obj.xyz") == Format::other);
  CHECK(format_named("ply-ascii") == Format::ply_ascii);
  CHECK(format_named("OFF") == Format::off);
  CHECK_FALSE(format_named("nonsense"));
  CHECK(name(Format::ply_big_endian) == "ply-big-endian");
}

TEST_CASE("A stream that fails is an error", "[io]") {
  std::ostringstream stream;
  stream.setstate(std::ios::badbit);
  CHECK_THROWS_AS(write_mesh(stream, tetrahedron, Format::obj), IoError);
}
