#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "extensions/convex/approximate_convex_set.h"
#include "extensions/convex/convex_solid.h"
#include "extensions/convex/membership.h"
#include "strata/check.h"
#include "strata/convex.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace strata::convex {
namespace {

using test::Random;

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }

Polytope polytope(const Mesh& mesh) { return *convex_solid(surface_of(test::exact(mesh))); }
Polytope point(const Vertex& v) { return {0, {v}, {}, {}}; }

/// By the definition, from pieces: a vertex of b and all triangles of a, each plus b. For convex b.
Solid by_pieces(const Solid& a, const Polytope& b) {
  std::vector<Solid> parts{minkowski_sum(a, Polytope{0, {b.vertices[0]}, {}, {}})};
  for (const Triangle& t : a.mesh().triangles)
    parts.push_back(Solid::trusted(mesh_of(sum(triangle_polytope(a.exact_mesh(), t), b))));
  return union_(parts);
}

/// For any b: pairs of triangles, and a vertex of every part of each.
Solid by_pieces(const Solid& a, const Solid& b) {
  std::vector<Solid> parts;
  for (const Vertex& v : b.mesh().vertices) parts.push_back(minkowski_sum(a, point(v)));
  for (const Vertex& v : a.mesh().vertices) parts.push_back(minkowski_sum(b, point(v)));
  for (const Triangle& t : a.mesh().triangles)
    for (const Triangle& u : b.mesh().triangles) {
      const Polytope piece = sum(triangle_polytope(a.exact_mesh(), t), triangle_polytope(b.exact_mesh(), u));
      if (piece.dimension == 3) parts.push_back(Solid::trusted(mesh_of(piece)));
    }
  return union_(parts);
}

Mesh small_convex(Random& random) {
  for (;;) {
    std::vector<Vertex> points;
    for (std::uint64_t i = 4 + random.below(3); i > 0; --i)
      points.push_back({static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
                        static_cast<double>(random.below(4))});
    Mesh hull = test::convex_hull(points);
    if (!hull.triangles.empty()) return hull;
  }
}

/// Some cells of a square lattice as columns of one height or two: rings of any shape, whose rims touch themselves in
/// vertices and have other columns beside them.
std::vector<Solid> columns(Random& random, int cells, double side) {
  std::vector<Solid> columns;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y) {
      const bool is_inner = x % (cells - 1) != 0 && y % (cells - 1) != 0;
      const double height = random.below(6) > 0 ? 1 : 2;
      if (random.below(is_inner ? 2 : 12) > 0)
        columns.push_back(box({x * side, y * side, 0}, {(x + 1) * side, (y + 1) * side, height}));
    }
  return columns;
}

/// The sums of all pairs of convex solids.
Solid of_pairs(const std::vector<Solid>& a, const std::vector<Solid>& b) {
  std::vector<Solid> sums;
  for (const Solid& p : a)
    for (const Solid& q : b) sums.push_back(Solid::trusted(mesh_of(sum(polytope(p.mesh()), polytope(q.mesh())))));
  return union_(sums);
}

Solid by_convex_pieces(const Solid& a, const Solid& b) {
  const Decomposition of_a = decompose(a), of_b = decompose(b);
  std::vector<Solid> sums;
  for (std::uint32_t p = 0; p < of_a.pieces.size(); ++p)
    for (std::uint32_t q = 0; q < of_b.pieces.size(); ++q)
      sums.push_back(solid_of(sum(of_a.polytope(p), of_b.polytope(q))));
  return union_(sums);
}

/// The sum is that of all pairs of convex pieces, in either order, sound, and the same for any number of threads.
void check_sum_of_pieces(const Solid& a, const Solid& b) {
  Options options;
  options.threads = 1;
  const Solid whole = minkowski_sum(a, b, options);
  options.threads = 2;
  const Solid again = minkowski_sum(a, b, options);
  REQUIRE(again.mesh().triangles == whole.mesh().triangles);
  REQUIRE(again.mesh().vertices == whole.mesh().vertices);
  REQUIRE(check(whole.exact_mesh()).empty());
  REQUIRE(minkowski_sum(b, a) == whole);
  REQUIRE(by_convex_pieces(a, b) == whole);
}

/// The same solid, its face at the height 0 without points inside: what touches it there is not told by vertices.
Solid without_low_points(const Solid& block) {
  Mesh mesh = block.mesh();
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v][2] == 0; });
  });
  const auto corner = [&](double x, double y) {
    const auto at = std::find(mesh.vertices.begin(), mesh.vertices.end(), Vertex{x, y, 0});
    return static_cast<std::uint32_t>(at - mesh.vertices.begin());
  };
  mesh.triangles.push_back({corner(0, 0), corner(0, 4), corner(4, 4)});
  mesh.triangles.push_back({corner(0, 0), corner(4, 4), corner(4, 0)});
  return Solid::trusted({mesh, block.exact_mesh().exact});
}

void check_sum_of_columns(std::uint64_t seed) {
  CAPTURE(seed);
  constexpr std::array<double, 5> sides{0.25, 0.5, 0.75, 1, 1.5};
  Random random(seed);
  const auto cells = static_cast<int>(2 + seed % 3);
  const std::vector<Solid> a = columns(random, 4, 1), b = columns(random, cells, sides[random.below(5)]);
  REQUIRE(minkowski_sum(union_(a), union_(b)) == of_pairs(a, b));
}

}  // namespace

TEST_CASE("boxes add up to boxes, and moving is adding a point", "[convex][minkowski]") {
  CHECK(minkowski_sum(box({0, 0, 0}, {1, 1, 1}), box({1, 2, 3}, {2, 4, 6})) == box({1, 2, 3}, {3, 5, 7}));
  const Solid l{test::l_shape()};
  CHECK(minkowski_sum(l, point({1, 2, 3})) == Solid(test::translated(test::l_shape(), {1, 2, 3})));
  CHECK(minkowski_sum(l, Solid()).is_empty());
  CHECK(minkowski_sum(Solid(), l).is_empty());
}

// Catches: voids that winding numbers leave where b holds a handle of a; rings in one plane, where they vanish at once.
TEST_CASE("a box fills the hole and the cavity that it does not fit into", "[convex][minkowski]") {
  const Solid with_hole{test::box_with_hole()}, with_cavity{test::box_with_cavity(2)};
  for (const double side : {0.25, 1 - 0x1p-53, 1.0, 1 + 0x1p-52, 2.0, 3.0, 5.0}) {
    CAPTURE(side);
    const Mesh b = test::box({0, 0, 0}, {side, side, side});
    CHECK(minkowski_sum(with_hole, Solid(b)) == by_pieces(with_hole, polytope(b)));
    CHECK(minkowski_sum(with_cavity, Solid(b)) == by_pieces(with_cavity, polytope(b)));
  }
}

// Catches: rings taken for larger than they are, by rims that touch themselves or have more rims beside them.
TEST_CASE("flat rings of any shape, with what fits into their holes and what does not", "[convex][minkowski]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) check_sum_of_columns(seed);
  for (const std::uint64_t telling : {314, 326}) check_sum_of_columns(telling);
}

TEST_CASE("more flat rings", "[.][slow][minkowski]") {
  for (std::uint64_t seed = 30; seed < 1000; ++seed) check_sum_of_columns(seed);
}

// Catches: a wall between two parts of one solid taken for something that is in the way.
TEST_CASE("parts that touch in a face are one solid to an erosion", "[convex][minkowski]") {
  const std::vector<Mesh> halves{test::box({0, 0, 0}, {2, 4, 4}), test::box({2, 0, 0}, {4, 4, 4})};
  const Solid both{test::merged(halves)};
  CHECK(erosion(both, box({0, 0, 0}, {1, 1, 1})) == box({0, 0, 0}, {3, 3, 3}));
  CHECK(minkowski_sum(both, box({0, 0, 0}, {1, 1, 1})) == box({0, 0, 0}, {5, 5, 5}));
}

// Catches: faces and edges in rings under a polygon in parallel, where no sum of a face and it has a volume.
TEST_CASE("a polygon closes the holes of rings in parallel planes", "[convex][minkowski]") {
  const Solid ring{test::box_with_hole()};
  for (const double side : {1.0, 4.0}) {
    CAPTURE(side);
    const Polytope square{2, {{0, 0, 0}, {0, side, 0}, {side, 0, 0}, {side, side, 0}}, {}, {{0, 2, 3, 1}}};
    const Polytope slab = polytope(test::box({0, 0, 0}, {side, side, 1}));
    const Polytope up{1, {{0, 0, 0}, {0, 0, 1}}, {}, {}};
    CHECK(minkowski_sum(minkowski_sum(ring, square), up) == minkowski_sum(ring, slab));
  }
}

// Catches: a half-space that a vertex is not in whose product is no number.
TEST_CASE("doubles never miss a point of a triangle, however large", "[convex][property]") {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    CAPTURE(i);
    const auto size = static_cast<int>(345 + random.below(25)), down = static_cast<int>(25 + random.below(20));
    const auto vertex = [&](int exponent) {
      Vertex v;
      for (double& x : v) x = std::ldexp(2 * random.unit() - 1, exponent);
      return v;
    };
    const std::array<Vertex, 3> t{vertex(size), Vertex{0, 0, 0},
                                  vertex(size - 20 - static_cast<int>(random.below(28)))};
    Vertex on_side = t[0];
    for (double& x : on_side) x = std::ldexp(x, -down);
    ApproximateConvexSet triangle({t[0], t[1], t[2]});
    triangle.add_facet(t[0], t[1], t[2]);
    triangle.add_facet(t[0], t[2], t[1]);
    for (const Vertex& v : {t[0], t[1], t[2], on_side})
      REQUIRE_FALSE(sum_misses(triangle, ApproximateConvexSet({Vertex{0, 0, 0}}), v));
  }
}

// Catches: a slice that a notch makes a hole in, however near to the face that it touches with its tip or its ridge.
TEST_CASE("a polygon along a face that a notch touches from inside", "[convex][minkowski]") {
  const Mesh block = test::box({0, 0, 0}, {4, 4, 2});
  const Polytope square{2, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {}, {{0, 2, 3, 1}}};
  // Wider than the square where they are open: no ring fits.
  const std::vector<Vertex> tip{{2, 2, 0}, {0.5, 0.5, 2.5}, {3.5, 0.5, 2.5}, {2, 3.5, 2.5}};
  const std::vector<Vertex> ridge{{2, 1.75, 0},    {2, 2.25, 0},    {0.5, 0.5, 2.5},
                                  {3.5, 0.5, 2.5}, {0.5, 3.5, 2.5}, {3.5, 3.5, 2.5}};
  for (const auto& notch : {tip, ridge}) {
    const Solid both[] = {Solid(block), Solid(test::convex_hull(notch))};
    const Solid a = difference(both);
    CHECK(minkowski_sum(a, square) == by_pieces(a, square));
    const Polytope cube = polytope(test::box({0, 0, 0}, {1, 1, 1}));
    CHECK(minkowski_sum(a, cube) == by_pieces(a, cube));
    CHECK(minkowski_sum(without_low_points(a), square) == by_pieces(a, square));
  }
}

// The sum closes everywhere at once, or by one step of doubles nowhere.
TEST_CASE("a cross-shaped key in its cross-shaped slot, a step of doubles less and more", "[convex][minkowski]") {
  const Solid slot = box({-4, -4, 0}, {4, 4, 1}) - (box({-2, -1, -1}, {2, 1, 2}) | box({-1, -2, -1}, {1, 2, 2}));
  for (const double u : {1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
    CAPTURE(u);
    const Solid key = box({-2 * u, -u, 0}, {2 * u, u, 1}) | box({-u, -2 * u, 0}, {u, 2 * u, 1});
    check_sum_of_pieces(slot, key);
  }
}

TEST_CASE("nested shells plus two cubes that meet in a corner", "[convex][minkowski]") {
  Solid shells = box({0, 0, 0}, {9, 9, 9}) - box({1, 1, 1}, {8, 8, 8});
  shells = shells | (box({2, 2, 2}, {7, 7, 7}) - box({3, 3, 3}, {6, 6, 6})) | box({4, 4, 4}, {5, 5, 5});
  check_sum_of_pieces(shells, box({0, 0, 0}, {.5, .5, .5}) | box({.5, .5, .5}, {1, 1, 1}));
}

TEST_CASE("what is left of sums of sums is an operand like others", "[convex][minkowski]") {
  const Solid ring = (box({0, 0, 0}, {3, 3, 1}) - box({1, 1, -1}, {2, 2, 2})) | box({3, 3, 0}, {4, 4, 1});
  const Solid grown = minkowski_sum(ring, box({0, 0, 0}, {0.1, 0.2, 0.3}));
  const Solid rest = minkowski_sum(grown, ring) - minkowski_sum(ring, box({0, 0, 0}, {0.7, 0.1, 0.1}));
  REQUIRE_FALSE(rest.is_empty());
  check_sum_of_pieces(rest, ring);
  check_sum_of_pieces(grown, grown);
}

TEST_CASE("random solids plus convex ones are what their pieces are", "[convex][minkowski][property]") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Solid a{test::lattice_solid(random)};
    const Mesh b = small_convex(random);
    const Solid found = minkowski_sum(a, Solid(b));
    REQUIRE(found == by_pieces(a, polytope(b)));
  }
}

TEST_CASE("random solids plus others are what pairs of pieces are", "[convex][minkowski][property]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Mesh a = test::lattice_solid(random), b = test::lattice_solid(random);
    if (a.triangles.size() * b.triangles.size() > 1500) continue;
    const Solid found = minkowski_sum(Solid(a), Solid(b));
    REQUIRE(found == by_pieces(Solid(a), Solid(b)));
    REQUIRE(found == minkowski_sum(Solid(b), Solid(a)));
  }
}

TEST_CASE("sums obey the laws of sums", "[convex][minkowski][property]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(1000 + seed);
    const Solid a{test::lattice_solid(random)}, b{test::lattice_solid(random)}, c{small_convex(random)},
        d{small_convex(random)};
    const Solid a_c = minkowski_sum(a, c);
    CHECK(minkowski_sum(a | b, c) == (a_c | minkowski_sum(b, c)));
    CHECK(minkowski_sum(a_c, d) == minkowski_sum(a, minkowski_sum(c, d)));
    CHECK((a_c - minkowski_sum(a | b, c)).is_empty());
    const Solid eroded = erosion(a, c);
    CHECK((minkowski_sum(eroded, c) - a).is_empty());
    CHECK((a - erosion(a_c, c)).is_empty());
  }
}

TEST_CASE("segments and polygons sweep solids", "[convex][minkowski][property]") {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Solid a{test::lattice_solid(random)};
    const Mesh triangle{
        {{0, 0, 0}, {0, 1, static_cast<double>(random.below(3))}, {1, static_cast<double>(random.below(2)), 0}},
        {{0, 1, 2}}};
    const Polytope polygon = triangle_polytope(ExactMesh{triangle, {}}, {0, 1, 2});
    const Polytope sweep{1, {{0, 0, 0}, {1, static_cast<double>(random.below(2)), 0}}, {}, {}};
    CHECK(minkowski_sum(a, sweep) == by_pieces(a, sweep));
    CHECK(minkowski_sum(a, polygon) == by_pieces(a, polygon));
  }
}

}  // namespace strata::convex
