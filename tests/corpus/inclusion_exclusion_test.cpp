#include <catch2/catch.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "corpus/corpus.h"
#include "corpus/operands.h"
#include "support/transform.h"

namespace strata::test {
namespace {

const std::string coref = "csg/cgal-tests/Polygon_mesh_processing/test/Polygon_mesh_processing/data-coref/";
const std::string classics = "meshes/common-3d-test-models/data/";
const std::string libigl = "meshes/libigl-tutorial-data/";

void check_laws(const std::string& name, const Solid& a, const Solid& b) {
  CAPTURE(name);
  try {
    const Rational common = (a & b).volume();
    CHECK((a | b).volume() + common == a.volume() + b.volume());
    CHECK((a - b).volume() == a.volume() - common);
    CHECK((a ^ b).volume() == a.volume() + b.volume() - 2 * common);
  } catch (const std::exception& e) {
    FAIL_CHECK("threw: " << e.what());
  }
}

void check_files(const std::filesystem::path& root, const std::string& a, const std::string& b) {
  check_laws(short_name(a) + " and " + short_name(b), Solid(load(root, a)), Solid(load(root, b)));
}

void check_rotated_copy(const std::filesystem::path& root, const std::string& path) {
  const Mesh mesh = load(root, path);
  check_laws(short_name(path) + " and its rotated copy", Solid(mesh), Solid(rotated_copy(mesh)));
}

/// Union and intersection of the scaled operands are exactly the scaled ones.
void check_scaled(const std::string& name, const MeshPair& pair, int exponent) {
  CAPTURE(name, exponent);
  const Solid a(scaled(pair.a, exponent));
  const Solid b(scaled(pair.b, exponent));
  check_laws(name, a, b);
  const Integer power = pow(Integer(2), static_cast<unsigned>(3 * std::abs(exponent)));
  const Rational factor = exponent < 0 ? Rational(1, power) : Rational(power);
  CHECK((a & b).volume() == factor * (Solid(pair.a) & Solid(pair.b)).volume());
}

}  // namespace

TEST_CASE("volumes of the coplanar cases obey inclusion and exclusion exactly", "[corpus][volume]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  for (const std::string partner :
       {"coplanar_with_cube", "coplanar_with_cube1", "coplanar_with_cube2", "coplanar_with_cube3",
        "coplanar_with_cube4", "cube_on_cube_edge", "cube_on_cube_corner", "with_cube", "cube_interior_tgt"}) {
    check_files(*root, coref + "cube.off", coref + partner + ".off");
  }
  const ExactMesh octahedron = exact(load(*root, "csg/cgal-tests/Nef_3/test/Nef_3/data/octa.off"));
  const RationalPoint ninths{Rational(3, 9), Rational(4, 9), Rational(5, 9)};
  check_laws("octahedra", Solid(octahedron), Solid(translated(octahedron, ninths)));
}

TEST_CASE("volumes of real pairs obey inclusion and exclusion exactly", "[corpus][volume]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  const std::string models = "csg/manifold/test/models/";
  check_files(*root, models + "Havocglass8_left.obj", models + "Havocglass8_right.obj");
  check_files(*root, models + "Offset3.obj", models + "Offset4.obj");
  check_files(*root, libigl + "cheburashka.off", libigl + "decimated-knight.off");
  check_files(*root, "meshes/trimesh/models/ballA.off", "meshes/trimesh/models/ballB.off");
}

TEST_CASE("volumes of printed objects obey inclusion and exclusion exactly", "[corpus][volume][slow]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  for (const std::string number : {"16", "84", "667"}) {
    const MeshPair pair = ember_pair(*root, number);
    check_laws("printed objects, case " + number, Solid(pair.a), Solid(pair.b));
  }
}

TEST_CASE("classic meshes and their rotated copies obey inclusion and exclusion exactly", "[corpus][volume]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  for (const std::string& path :
       {classics + "cheburashka.obj", classics + "fandisk.obj", classics + "rocker-arm.obj"}) {
    check_rotated_copy(*root, path);
  }
}

TEST_CASE("large classic meshes and their copies obey inclusion and exclusion exactly", "[corpus][volume][slow]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  check_rotated_copy(*root, libigl + "armadillo.obj");
  check_rotated_copy(*root, classics + "nefertiti.obj");
  const std::vector<std::pair<std::string, Vertex>> shifts{
      {classics + "rocker-arm.obj", {0.0302734375, 0.0361328125, 0.0498046875}},
      {classics + "fandisk.obj", {0.484375, 0.3671875, 0.1328125}},
      {libigl + "armadillo.obj", {0.083984375, 0.0703125, 0.0380859375}}};
  for (const auto& [path, by] : shifts) {
    const Mesh mesh = load(*root, path);
    check_laws(short_name(path) + " and its translated copy", Solid(mesh), Solid(translated(mesh, by)));
  }
}

// Catches: filters that overflow or underflow, exponents that do not fit.
TEST_CASE("volumes scale exactly near 1e-200 and 1e150", "[corpus][volume][scale]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  const Mesh fandisk = load(*root, classics + "fandisk.obj");
  const MeshPair knight{load(*root, libigl + "cheburashka.off"), load(*root, libigl + "decimated-knight.off")};
  for (const int exponent : {-664, 498}) {
    check_scaled("cheburashka and knight", knight, exponent);
    check_scaled("fandisk and its rotated copy", {fandisk, rotated_copy(fandisk)}, exponent);
  }
}

}  // namespace strata::test
