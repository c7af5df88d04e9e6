#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "convex/decomposition_check.h"
#include "strata/convex.h"
#include "strata/transform.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::test {
namespace {

using convex::decompose;
using convex::Decomposition;

/// Sets of pieces that are connected by walls.
std::size_t connected_sets(const Decomposition& d) {
  std::vector<std::uint32_t> parent(d.pieces.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t p) {
    while (parent[p] != p) p = parent[p];
    return p;
  };
  for (const convex::Wall& wall : d.walls) parent[root(wall.pieces[0])] = root(wall.pieces[1]);
  std::size_t sets = 0;
  for (std::uint32_t p = 0; p < parent.size(); ++p) sets += parent[p] == p ? 1 : 0;
  return sets;
}

/// Decomposes and checks, the number of pieces as well: a connected solid without reflex edges is one.
Decomposition checked(const Solid& solid) {
  Decomposition d = decompose(solid);
  REQUIRE(fault_of(d, solid).empty());
  const std::size_t r = d.reflex_edges;
  CHECK(d.pieces.size() <= connected_sets(d) + r + r * r / 4);
  return d;
}

/// A polygon, counter-clockwise and not convex, as a prism: its faces above and below are fans of nothing, so the solid
/// is made of thin boxes that overlap.
Solid union_of_boxes(const std::vector<std::array<Vertex, 2>>& boxes) {
  std::vector<Solid> solids;
  for (const auto& [lower, upper] : boxes) solids.emplace_back(box(lower, upper));
  return union_(solids);
}

/// A square spiral of corridors, in a plane.
Solid spiral(int arms) {
  std::vector<std::array<Vertex, 2>> boxes;
  int x = 0, y = 0;
  constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (int k = 0; k < arms; ++k) {
    const int length = 2 * (k / 2 + 1);
    const int to_x = x + steps[static_cast<std::size_t>(k % 4)][0] * length;
    const int to_y = y + steps[static_cast<std::size_t>(k % 4)][1] * length;
    boxes.push_back({Vertex{double(std::min(x, to_x)), double(std::min(y, to_y)), 0},
                     Vertex{double(std::max(x, to_x) + 1), double(std::max(y, to_y) + 1), 1}});
    x = to_x;
    y = to_y;
  }
  return union_of_boxes(boxes);
}

/// Two combs whose teeth look at one another at right angles: the example that needs r^2 pieces, with straight teeth.
Solid crossed_combs(int teeth) {
  const Solid block(box({0, 0, 0}, {2.0 * teeth + 1, 2.0 * teeth + 1, 10}));
  std::vector<Solid> slots{block};
  for (int k = 0; k < teeth; ++k) {
    slots.emplace_back(box({2.0 * k + 1, -1, 6}, {2.0 * k + 2, 2.0 * teeth + 2, 11}));
    slots.emplace_back(box({-1, 2.0 * k + 1, -1}, {2.0 * teeth + 2, 2.0 * k + 2, 4}));
  }
  return difference(slots);
}

Solid comb(int teeth) {
  std::vector<std::array<Vertex, 2>> boxes{{Vertex{0, 0, 0}, Vertex{2.0 * teeth, 1, 1}}};
  for (int k = 0; k < teeth; ++k) boxes.push_back({Vertex{2.0 * k, 1, 0}, Vertex{2.0 * k + 1, 3, 1}});
  return union_of_boxes(boxes);
}

Mesh torus(int n, int m) {
  Mesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m;
      mesh.vertices.push_back({(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// A sphere whose vertices are pulled out and in.
Mesh star(Random& random, int level) {
  Mesh mesh = icosphere({0, 0, 0}, 1, level);
  for (Vertex& v : mesh.vertices) {
    const double factor = 1 + 2 * random.unit();
    for (double& x : v) x *= factor;
  }
  return mesh;
}

}  // namespace

TEST_CASE("a convex solid is one piece, with the facets of the solid", "[convex]") {
  CHECK(checked(Solid(box({0, 0, 0}, {1, 2, 3}))).pieces.size() == 1);
  CHECK(checked(Solid(cube_grid(3))).pieces.at(0).size() == 6);  // coplanar triangles are one facet
  const Decomposition d = checked(Solid(octahedron({1, 1, 1}, 0.1)));
  CHECK(d.pieces.size() == 1);
  CHECK(d.walls.empty());
  CHECK(d.reflex_edges == 0);
  CHECK(convex::mesh_of(d.polytope(0)).mesh.triangles.size() == 8);
  CHECK(decompose(Solid()).pieces.empty());
}

TEST_CASE("small solids have as few pieces as they can", "[convex]") {
  CHECK(checked(Solid(l_shape())).pieces.size() == 2);
  CHECK(checked(Solid(l_shape())).walls.size() == 1);
  CHECK(checked(Solid(box_with_hole())).pieces.size() == 4);
  CHECK(checked(Solid(box_with_cavity(2))).pieces.size() == 6);
  CHECK(checked(comb(6)).pieces.size() == 7);
  CHECK(checked(spiral(9)).pieces.size() == 9);
}

TEST_CASE("parts that touch in an edge or a vertex are pieces of their own", "[convex][degenerate]") {
  for (const Mesh& mesh : {edge_sharing_cells(), vertex_sharing_cells()}) {
    const Decomposition d = checked(Solid(mesh));
    CHECK(d.pieces.size() == 2);
    CHECK(d.walls.empty());
  }
}

TEST_CASE("the teeth of two combs make pieces by their product, not more", "[convex]") {
  for (const int teeth : {1, 2, 4, 6}) {
    const Decomposition d = checked(crossed_combs(teeth));
    CHECK(d.reflex_edges == static_cast<std::size_t>(4 * teeth));
    CHECK(d.pieces.size() <= static_cast<std::size_t>((teeth + 1) * 2 + 1));
  }
}

TEST_CASE("spirals, combs, tori, stars and solids with cavities fall into convex pieces", "[convex][property]") {
  for (int k = 1; k <= static_cast<int>(rounds(9)); ++k) {
    CAPTURE(k);
    checked(spiral(k));
    checked(comb(k));
    checked(Solid(torus(3 + k, 3 + k / 2)));
    checked(Solid(box_with_cavity(k / 4.0)));
    Random random(static_cast<std::uint64_t>(k));
    checked(Solid(star(random, k == 2 ? 2 : k % 2)));
  }
}

TEST_CASE("solids that touch themselves and one another fall into convex pieces", "[convex][property]") {
  for (std::uint64_t seed = 0; seed < rounds(150); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    checked(Solid(pair.meshes[0]) | Solid(pair.meshes[1]));
    checked(Solid(pair.meshes[0]) - Solid(pair.meshes[1]));
    Random random(seed);
    checked(Solid(kuhn_solid(random, {2, 2, 2}, 2)));
  }
}

TEST_CASE("vertices that are no doubles and scales beyond reason are decomposed exactly", "[convex][degenerate]") {
  for (std::uint64_t seed = 0; seed < rounds(40); ++seed) {
    CAPTURE(seed);
    const Operands pair = touching_pair(seed);
    const Transform thirds(Transform::scaling({Rational(1, 3), Rational(2, 7), 1}) *
                           Transform::translation({Rational(1, 9), 0, Rational(-5, 11)}));
    const Solid solid = Solid(pair.meshes[0]) - Solid(pair.meshes[1]);
    checked(Solid(transform(solid.exact_mesh(), thirds, Placement::exact)));
    Random random(seed);
    const Rational huge = to_rational(1e280), tiny = to_rational(1e-280);
    checked(Solid(transform({lattice_solid(random), {}}, Transform::scaling({huge, 1, tiny}), Placement::exact)));
  }
}

TEST_CASE("a decomposition can be cancelled and tells how far it is", "[convex]") {
  const Solid solid(torus(40, 20));
  double last = 0;
  const Progress progress = [&](double fraction) {
    CHECK(fraction >= last);
    last = fraction;
  };
  static_cast<void>(decompose(solid, Monitor(nullptr, &progress)));
  CHECK(last == Approx(1).margin(0.05));
  CancelToken cancel;
  cancel.cancel();
  CHECK_THROWS_AS(decompose(solid, Monitor(&cancel)), Cancelled);
}

// Catches: a part that is lost where three parts touch without common vertices.
TEST_CASE("a solid that touches itself away from its vertices is not divided in silence", "[convex]") {
  const Mesh mesh{{{0, 3, 3},
                   {2, 3, 3.5},
                   {0.5, 3.5, 1},
                   {3, 1, 0},
                   {2, 2, 4},
                   {4, 0, 2},
                   {0, 3, 3},
                   {1, 1, 3.5},
                   {1, 3, 7},
                   {1, 3.5, 5},
                   {1, 2.25, 4.25},
                   {1, 3.25, 5.25},
                   {1, 3.25, 3.25},
                   {3, 5.25, 2.25}},
                  {{0, 1, 2},
                   {0, 2, 3},
                   {0, 4, 1},
                   {0, 5, 4},
                   {0, 3, 5},
                   {2, 1, 3},
                   {4, 5, 1},
                   {1, 5, 3},
                   {6, 7, 8},
                   {6, 9, 7},
                   {6, 8, 9},
                   {7, 9, 8},
                   {10, 11, 12},
                   {10, 12, 13},
                   {10, 13, 11},
                   {12, 11, 13}}};
  const Solid solid(mesh, InputClass::solid);
  CHECK_THROWS_AS(decompose(solid), std::invalid_argument);
  const Solid resolved(mesh);
  CHECK(resolved.volume() == solid.volume());
  checked(resolved);
}

}  // namespace strata::test
