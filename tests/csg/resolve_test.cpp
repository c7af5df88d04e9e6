#include "strata/resolve.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "strata/check.h"
#include "strata/combine.h"
#include "support/append.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/shuffled.h"

using namespace strata;

namespace {

Solid resolved(const Mesh& mesh, Inside inside, InputClass input = InputClass::automatic) {
  return resolve({mesh, {}}, inside, {.input = input});
}

Mesh two_boxes(double shift, bool is_reversed = false) {
  Mesh mesh = test::box({0, 0, 0}, {2, 2, 2});
  test::append(mesh, test::box({shift, 0, 0}, {shift + 2, 2, 2}), is_reversed);
  return mesh;
}

/// The corners of each triangle from its lowest one, and the face that it is a part of: sorted.
std::vector<std::pair<std::array<Vertex, 3>, std::uint32_t>> triangles_of(const BooleanResult& result) {
  std::vector<std::pair<std::array<Vertex, 3>, std::uint32_t>> all;
  for (std::size_t n = 0; n < result.mesh.triangles.size(); ++n) {
    std::array<Vertex, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = result.mesh.vertices[result.mesh.triangles[n][i]];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.emplace_back(corners, result.sources[n].face);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("boxes that overlap by half, by all three rules", "[csg]") {
  const Mesh crossing = two_boxes(1);
  CHECK(resolved(crossing, Inside::winding).volume() == 12);
  CHECK(resolved(crossing, Inside::even_odd).volume() == 8);
  CHECK(resolved(crossing, Inside::outer).volume() == 12);
  CHECK_FALSE(resolved(crossing, Inside::winding).notes().empty());

  const Mesh opposite = two_boxes(1, true);
  CHECK(resolved(opposite, Inside::even_odd).volume() == 8);
}

TEST_CASE("the orientation of the whole matters to winding numbers only", "[csg]") {
  Mesh inside_out;
  test::append(inside_out, test::box({0, 0, 0}, {3, 3, 3}), true);
  test::append(inside_out, test::box({1, 1, 1}, {2, 2, 2}), false);
  CHECK_THROWS_AS(resolved(inside_out, Inside::winding), InputError);
  CHECK(resolved(inside_out, Inside::even_odd).volume() == 26);
  CHECK(resolved(inside_out, Inside::outer).volume() == 27);
}

TEST_CASE("a box in a box in a box", "[csg]") {
  Mesh nested = test::box({0, 0, 0}, {5, 5, 5});
  test::append(nested, test::box({1, 1, 1}, {4, 4, 4}));
  test::append(nested, test::box({2, 2, 2}, {3, 3, 3}));
  const Solid winding = resolved(nested, Inside::winding);
  CHECK(winding.volume() == 125);
  CHECK_FALSE(winding.notes().empty());  // winding numbers up to 3
  const Solid even_odd = resolved(nested, Inside::even_odd);
  CHECK(even_odd.volume() == 125 - 27 + 1);
  CHECK(even_odd.components().size() == 2);
  CHECK(even_odd.without_cavities() == winding);
  CHECK(resolved(nested, Inside::outer) == winding);
}

TEST_CASE("what touches the outside in edges only is closed off", "[csg]") {
  const Solid cube(test::box({0, 0, 0}, {6, 6, 6}));
  const Solid cavity(Mesh{{{2, 1, 6}, {2, 3, 6}, {1, 2, 3}, {3, 2, 3}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}});
  CHECK((cube - cavity).without_cavities() == cube);
  CHECK(resolved((cube - cavity).mesh(), Inside::outer) == cube);
  const Solid lid(Mesh{{{2, 2, 6}, {4, 2, 6}, {4, 4, 6}, {2, 4, 6}, {3, 3, 7}, {3, 3, 5}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}});
  const Solid closed = (cube - Solid(test::box({2, 2, 2}, {4, 4, 6}))) | lid;
  CHECK(closed.components().size() == 2);
  CHECK(closed.without_cavities() == (cube | lid));
}

TEST_CASE("a solid stays as it is", "[csg]") {
  const Mesh sphere = test::icosphere({0, 0, 0}, 1, 3);
  for (const Inside inside : all_insides) {
    const Solid solid = resolved(sphere, inside);
    CHECK(solid.mesh().triangles == sphere.triangles);
    CHECK(solid.notes().empty());
  }
  CHECK(resolved({}, Inside::outer).is_empty());
}

// Laws by random collections of boxes and tetrahedra on a small lattice, of any orientation.
TEST_CASE("laws of resolved meshes", "[csg][property]") {
  const unsigned seed = GENERATE(range(0u, 150u));
  std::mt19937 random(seed);
  const auto number = [&](unsigned n) { return static_cast<double>(random() % n); };
  Mesh mesh;
  for (unsigned i = 0; i < 1 + random() % 4; ++i) {
    const Vertex lower{number(4), number(4), number(4)};
    test::append(mesh, test::box(lower, {lower[0] + 1 + number(3), lower[1] + 1 + number(3), lower[2] + 1 + number(3)}),
                 random() % 3 == 0);
  }
  const Solid even_odd = resolved(mesh, Inside::even_odd), outer = resolved(mesh, Inside::outer);
  CHECK(check(even_odd.exact_mesh()).empty() == true);
  CHECK(even_odd - outer == Solid());
  CHECK(outer.without_cavities() == outer);
  CHECK(resolve(outer.exact_mesh(), Inside::even_odd) == outer);
  CHECK(resolve(even_odd.exact_mesh()) == even_odd);
  try {
    const Solid winding = resolved(mesh, Inside::winding);
    CHECK(winding - outer == Solid());
    CHECK(winding == Solid(mesh, InputClass::overlapping));
    CHECK(winding == Solid(mesh));
  } catch (const InputError&) {
    CHECK_THROWS_AS(Solid(mesh), InputError);
  }
}

TEST_CASE("meshes of which few faces cross are resolved as those of which many do", "[csg][resolve][property]") {
  // Balls of many faces, and boxes on a small grid whose faces coincide: as one mesh, and as operands.
  test::Random random(12);
  const auto at = [&] { return static_cast<double>(random.between(-2, 2)); };
  for (int round = 0; round < 25; ++round) {
    Mesh all;
    Solid united;
    const auto add = [&](const Mesh& part, bool is_cavity) {
      united = is_cavity ? united - Solid(part) : united | Solid(part);
      test::append(all, part, is_cavity);
    };
    for (int n = 0; n < 3; ++n) {
      const Vertex low{at(), at(), at()};
      add(test::box(low, {low[0] + random.between(1, 2), low[1] + random.between(1, 2), low[2] + random.between(1, 2)}),
          false);
    }
    add(test::icosphere({at() / 2, at() / 2, at() / 2}, 1.5, 4), false);
    const Solid resolved = resolve({all, {}}, Inside::winding);
    CHECK(resolved == united);
    CHECK(check(resolved.mesh()).empty());
    // A hole through it, as faces that wind the other way: 0 where one thing was, 1 where two were.
    add(test::icosphere({9, 0, 0}, 1, 3), false);
    add(test::box({8.75, -0.25, -0.25}, {9.25, 0.25, 0.25}), true);
    CHECK(resolve({all, {}}, Inside::winding) == united);
  }
}

// Class `automatic` finds the pairs that cross before it resolves them, class `overlapping` while it does.
TEST_CASE("what crosses is the same, whoever searches for it", "[csg][resolve][property]") {
  const unsigned seed = GENERATE(range(0u, 60u));
  test::Random random(seed);
  const auto at = [&] { return static_cast<double>(random.between(-2, 2)); };
  Mesh mesh;
  for (int n = random.between(2, 4); n > 0; --n) {
    const Vertex low{at(), at(), at()};
    const bool is_ball = random.between(0, 1) == 0;
    test::append(mesh, is_ball ? test::icosphere(low, 1.5, static_cast<int>(random.between(0, 3)))
                               : test::box(low, {low[0] + 1, low[1] + 2, low[2] + 1}));
  }
  if (random.between(0, 2) == 0) {  // a vertex on an edge, and a face of zero area: to be prepared
    const auto [a, b, c] = mesh.triangles.front();
    const Vertex p = mesh.vertices[a], q = mesh.vertices[b];
    const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    mesh.triangles.front() = {a, m, c};
    mesh.triangles.push_back({m, b, c});
    mesh.triangles.push_back({a, b, m});
  }
  const MeshView operand = mesh;
  const auto united = [&](InputClass input) {
    return triangles_of(combine(Operation::union_, std::span(&operand, 1), {.input = input}));
  };
  CHECK(united(InputClass::automatic) == united(InputClass::overlapping));
}

TEST_CASE("a large mesh in any order is inspected as it is", "[csg]") {
  const Mesh ordered = test::icosphere({0, 0, 0}, 1, 7);
  REQUIRE(ordered.vertices.size() > 100'000);
  Mesh mesh = test::shuffled(ordered, 1);
  CHECK(check(mesh).empty());
  const std::uint32_t moved = mesh.triangles[5][1];
  mesh.vertices[moved] = {-2 * mesh.vertices[moved][0], -2 * mesh.vertices[moved][1], -2 * mesh.vertices[moved][2]};
  const std::vector<Defect> defects = check(mesh);
  REQUIRE_FALSE(defects.empty());
  CHECK(defects[0].kind == DefectKind::self_intersection);
  for (const std::uint32_t f : defects[0].faces) CHECK(f < mesh.triangles.size());
  Mesh inside_out = mesh;
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK_FALSE(check(inside_out).empty());
  mesh.vertices[moved][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK(check(mesh)[0].kind == DefectKind::non_finite_coordinate);
  mesh.vertices[moved][0] = 0;
  mesh.triangles[9][0] = 0xffff'fff0;
  CHECK_FALSE(check(mesh).empty());
}

// Around the line in which three faces cross, all six sheets are in the boundary, and none of them ends there.
TEST_CASE("faces that cross in one line, and are kept on both sides, have it as an edge", "[csg]") {
  const std::vector<Vertex> at = {{0, 2, 2}, {0, 3, 1}, {1, 2, 2}, {3, 0, 0}, {1, 2, 1}, {2, 0, 1},
                                  {2, 0, 2}, {2, 2, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 2}, {2, 2, 1}};
  const std::vector<Triangle> first_two = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3},
                                           {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}};
  Mesh mesh{at, first_two};
  for (const Triangle& t : {Triangle{10, 9, 8}, {11, 10, 8}, {8, 9, 11}, {11, 9, 10}}) mesh.triangles.push_back(t);
  for (const Inside inside : {Inside::winding, Inside::even_odd, Inside::outer}) {
    const Solid solid = resolved(mesh, inside);
    CHECK(check(solid.exact_mesh()).empty());
  }
}
