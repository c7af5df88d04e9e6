#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "strata/strata.h"
#include "support/append.h"
#include "support/shapes.h"
#include "support/subdivision.h"
#include "support/touching.h"

using namespace strata;

namespace {

/// The exact result on these meshes, in canonical form.
CanonicalForm result_of(Operation op, const std::vector<Mesh>& meshes) {
  const std::vector<MeshView> views(meshes.begin(), meshes.end());
  BooleanResult r = combine(op, std::span<const MeshView>(views), {.exact_vertices = true});
  return canonical_form(ExactMesh{std::move(r.mesh), std::move(r.exact)});
}

/// Tilts all axis-parallel planes; exact on lattice coordinates.
Mesh sheared(Mesh mesh) {
  for (Vertex& v : mesh.vertices) v = {v[0] + 3 * v[1] - v[2], v[1] + 5 * v[2] - 2 * v[0], v[2] + 7 * v[0] + v[1]};
  return mesh;
}

void check_subdivided(const std::vector<Mesh>& coarse, test::Random& random, int steps) {
  std::vector<Mesh> fine;
  for (const Mesh& m : coarse) fine.push_back(test::subdivided(m, random, random.between(0, steps)));
  for (const Operation op : all_operations) {
    CAPTURE(static_cast<int>(op));
    REQUIRE(result_of(op, fine) == result_of(op, coarse));
  }
}

/// Boxes on a small lattice, which touch in parts of faces more often than not.
std::vector<Mesh> lattice_boxes(test::Random& random, int count) {
  std::vector<Mesh> boxes;
  for (int i = 0; i < count; ++i) {
    Vertex lower, upper;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = random.between(0, 2);
      lower[k] = from;
      upper[k] = random.between(from + 1, 3);
    }
    boxes.push_back(test::box(lower, upper));
  }
  return boxes;
}

}  // namespace

// Catches: a covered face dropped where part of it stays, sides of a covered face mixed up, vertices that only one of
// the faces at an edge knows.
TEST_CASE("how operands are divided into triangles makes no difference", "[csg][property]") {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Mesh> boxes = lattice_boxes(random, random.between(2, 4));
    if (seed % 2 == 1) std::transform(boxes.begin(), boxes.end(), boxes.begin(), sheared);
    check_subdivided(boxes, random, 40);
  }
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    check_subdivided(test::touching_pair(seed).meshes, random, 30);
    check_subdivided(test::touching_operands(seed).meshes, random, 15);
  }
}

// Catches: faces on both sides of an edge taken for alike where another solid has the edge's ends, too, and ends there.
TEST_CASE("walls of squares hide what they cover, and no more", "[csg][property][degenerate]") {
  Formula formula(4);  // what covers a face of operand 0 hides it if it is operand 1, and else only in operand 3
  const std::array both{formula.operand(2), formula.operand(3)};
  const std::array any{formula.operand(0), formula.operand(1), formula.join(Formula::Join::all, both)};
  formula.close(formula.join(Formula::Join::any, any));
  const auto result = [&](const std::vector<Mesh>& meshes) {
    std::vector<Operand> operands;
    for (const Mesh& mesh : meshes) operands.push_back({.mesh = MeshView(mesh), .exact = {}});
    BooleanResult r = combine(formula, operands, {.exact_vertices = true});
    return canonical_form(ExactMesh{std::move(r.mesh), std::move(r.exact)});
  };
  test::Random random(5);
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    std::vector<Mesh> coarse, fine;
    const auto add = [&](const std::array<int, 3>& lower, const std::array<int, 3>& upper) {
      fine.push_back(test::box_in_squares(lower, upper, random.between(0, 1) == 1));
      coarse.push_back(test::box({double(lower[0]), double(lower[1]), double(lower[2])},
                                 {double(upper[0]), double(upper[1]), double(upper[2])}));
    };
    const int middle = random.between(1, 3), side = random.between(0, 2);
    add({0, 0, 0}, {1, 4, 4});
    add({1, 0, side}, {2, middle, 4});
    add({1, middle, 0}, {2, 4, 4 - side});
    if (round % 3 == 0) {
      add({random.between(1, 2), random.between(0, 3), 0}, {3, 4, random.between(1, 4)});
    } else {  // touches the walls between operands 1 and 2, and one of the parts into which diagonals divide a square
      Mesh tips;
      for (int z = 0; z < 4; ++z)
        if (random.between(0, 3) > 0) test::append(tips, test::octahedron({1.125, middle - 0.0625, z + 0.5}, 0.0625));
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) {
          constexpr std::array<std::array<double, 2>, 4> parts{
              {{0.5, 0.125}, {0.5, 0.875}, {0.125, 0.5}, {0.875, 0.5}}};
          const auto part = static_cast<std::size_t>(random.between(0, random.between(1, 4)));
          if (part < 4) test::append(tips, test::octahedron({1.0625, y + parts[part][0], z + parts[part][1]}, 0.0625));
        }
      fine.push_back(tips);
      coarse.push_back(tips);
    }
    REQUIRE(result(fine) == result(coarse));
  }
}

// Catches: faces on both sides of an edge taken for alike where they look in opposite directions.
TEST_CASE("walls hide cells that share an edge, each by itself", "[csg][degenerate]") {
  const Mesh cells = test::edge_sharing_cells();
  std::vector<Mesh> parts;
  for (const Solid& part : Solid(cells).components()) parts.push_back(part.mesh());
  REQUIRE(parts.size() == 2);
  test::Random random(3);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    Vertex lower, upper;
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = random.between(-1, 2);
      upper[k] = lower[k] + random.between(1, 4);
    }
    const Mesh wall = test::box(lower, upper);
    for (const Operation op : {Operation::union_, Operation::symmetric_difference}) {
      REQUIRE(result_of(op, {cells, wall}) == result_of(op, {parts[0], parts[1], wall}));
      REQUIRE(result_of(op, {wall, cells}) == result_of(op, {wall, parts[0], parts[1]}));
    }
  }
}

// Catches: a face dropped where one operand decides the formula above it and below, but not alike.
TEST_CASE("a formula that one operand decides is that operand, whatever covers it", "[csg][property][degenerate]") {
  using Join = Formula::Join;
  std::vector<Formula> formulas;
  for (const std::uint32_t kept : {0u, 1u}) {
    Formula alone(2), absorbing(2), absorbed(2);
    alone.close(alone.operand(kept));
    const std::array either{absorbing.operand(0), absorbing.operand(1)};
    const std::array outer{absorbing.operand(kept), absorbing.join(Join::any, either)};
    absorbing.close(absorbing.join(Join::all, outer));
    const std::array both{absorbed.operand(0), absorbed.operand(1)};
    const std::array wider{absorbed.operand(kept), absorbed.join(Join::all, both)};
    absorbed.close(absorbed.join(Join::any, wider));
    formulas.insert(formulas.end(), {alone, absorbing, absorbed});
  }
  const auto check = [&](const std::vector<Mesh>& meshes) {
    std::vector<Operand> operands;
    for (const Mesh& mesh : meshes) operands.push_back({.mesh = MeshView(mesh), .exact = {}});
    for (std::size_t i = 0; i < formulas.size(); ++i) {
      CAPTURE(i);
      BooleanResult r = combine(formulas[i], operands, {.exact_vertices = true});
      const Mesh& expected = meshes[i / 3];
      REQUIRE(canonical_form(ExactMesh{std::move(r.mesh), std::move(r.exact)}) ==
              result_of(Operation::union_, {expected}));
    }
  };
  check({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 0, 0}, {1, 1, 1})});
  check({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, -1, -1}, {2, 2, 2})});
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    check(test::touching_pair(seed).meshes);
  }
}

// Catches: sheets of one place, which solids do not have, taken for neighbours.
TEST_CASE("a wall that one operand lists twice is taken for two", "[csg][degenerate]") {
  Mesh cubes = test::box({0, 0, 0}, {1, 1, 1});
  const Mesh upper = test::box({0, 0, 1}, {1, 1, 2});
  std::vector<std::uint32_t> number;
  for (const Vertex& v : upper.vertices) {
    const auto place = std::find(cubes.vertices.begin(), cubes.vertices.end(), v);
    number.push_back(static_cast<std::uint32_t>(place - cubes.vertices.begin()));
    if (place == cubes.vertices.end()) cubes.vertices.push_back(v);
  }
  for (const Triangle& t : upper.triangles) cubes.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  const Solid whole(cubes, InputClass::solid), wall(test::box({-1, -1, 0}, {2, 2, 1}));
  CHECK((whole - wall).volume() == 1);
  CHECK((wall | whole).volume() == 10);
}
