#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "strata/strata.h"
#include "support/append.h"
#include "support/shapes.h"

using namespace strata;
using test::box;

namespace {

/// Facts about a result that survive re-triangulation.
struct Facts {
  Rational volume;
  double area;
  std::uint64_t components;
  std::int64_t euler;
  std::uint64_t non_manifold_edges, non_manifold_vertices;
};

void check(const Solid& s, const Facts& expected) {
  const Topology t = topology(s.exact_mesh());
  CHECK(s.volume() == expected.volume);
  CHECK(s.area() == Approx(expected.area).epsilon(1e-14));
  CHECK(t.components == expected.components);
  CHECK(t.euler == expected.euler);
  CHECK(t.non_manifold_edges == expected.non_manifold_edges);
  CHECK(t.non_manifold_vertices == expected.non_manifold_vertices);
  CHECK(t.open_edges == 0);
}

Solid unit() { return Solid(box({0, 0, 0}, {1, 1, 1})); }

}  // namespace

// Sabotage these catch: a cover on the wrong side, an owner that is not the lowest face, a crossing with its sign
// turned, a touch taken for a crossing.

TEST_CASE("boxes that share a face become one box", "[csg][degenerate]") {
  const Solid a = unit(), b(box({1, 0, 0}, {2, 1, 1}));
  check(a | b, {2, 10, 1, 2, 0, 0});
  CHECK((a & b).is_empty());
  CHECK((a - b) == a);
  CHECK((a ^ b) == (a | b));
  CHECK((a | b).canonical().facet_count() == 6);
}

TEST_CASE("boxes that share part of a face are joined there", "[csg][degenerate]") {
  const Solid a = unit(), b(box({1, .25, .5}, {2, .75, 1.5}));
  check(a | b, {Rational(3, 2), 6 + 4 - 0.5, 1, 2, 0, 0});
  CHECK((a & b).is_empty());
}

TEST_CASE("boxes that share an edge keep it once, with four triangles", "[csg][degenerate]") {
  const Solid a = unit(), b(box({1, 1, 0}, {2, 2, 1}));
  check(a | b, {2, 12, 1, 3, 1, 2});
  CHECK((a & b).is_empty());
}

TEST_CASE("boxes that share part of an edge keep that part once", "[csg][degenerate]") {
  const Solid a = unit(), b(box({1, 1, .5}, {2, 2, 2}));
  const Topology t = topology((a | b).exact_mesh());
  CHECK(t.non_manifold_edges == 1);
  CHECK((a | b).volume() == Rational(5, 2));
}

TEST_CASE("boxes that share a vertex keep it once", "[csg][degenerate]") {
  const Solid a = unit(), b(box({1, 1, 1}, {2, 2, 2}));
  check(a | b, {2, 12, 1, 3, 0, 1});
  CHECK((a & b).is_empty());
}

TEST_CASE("identical operands", "[csg][degenerate]") {
  const Solid a = unit();
  CHECK((a | a) == a);
  CHECK((a & a) == a);
  CHECK((a - a).is_empty());
  CHECK((a ^ a).is_empty());
}

TEST_CASE("an enclosed operand makes a cavity", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {4, 4, 4})), b(box({1, 1, 1}, {2, 2, 2}));
  check(a - b, {63, 102, 2, 4, 0, 0});
  CHECK((a | b) == a);
  CHECK((a & b) == b);
  CHECK((b - a).is_empty());
}

TEST_CASE("an operand that touches a face from inside", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {4, 4, 4})), b(box({1, 1, 0}, {2, 2, 2}));
  check(a - b, {62, 104, 1, 2, 0, 0});
  CHECK((a | b) == a);
  CHECK((a & b) == b);
  CHECK((a | b).mesh().triangles.size() < 30);  // merged: no trace of the wall
}

TEST_CASE("an operand that touches an edge from inside", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {4, 4, 4})), b(box({0, 0, 1}, {1, 1, 2}));
  check(a - b, {63, 96 + 4 - 2, 1, 2, 0, 0});
  CHECK((a | b) == a);
}

TEST_CASE("an apex on a face, from outside and from inside", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {4, 4, 4}));
  const Solid outside(test::tetrahedron({2, 2, 4}, {3, 2, 5}, {2, 3, 5}, {1, 1, 5}));
  const Solid inside(test::tetrahedron({2, 2, 4}, {1, 1, 3}, {2, 3, 3}, {3, 2, 3}));
  CHECK(topology((a | outside).exact_mesh()).non_manifold_vertices == 1);
  CHECK((a & outside).is_empty());
  CHECK((a - outside) == a);
  CHECK((a | inside) == a);
  CHECK((a & inside) == inside);
  CHECK(topology((a - inside).exact_mesh()).non_manifold_vertices == 1);
}

// Catches: merging that loses vertices which bound nothing in their own face.
TEST_CASE("an apex on a face that is merged, from inside, is a vertex of the face", "[csg][degenerate]") {
  // A pyramid whose apex touches a tetrahedron's face from inside, and one outside that shares the apex and has its
  // base in the plane of that face, so that the face is split and merged again.
  const Mesh two{{{2, 2.75, 1.5},
                  {2, 2.75, 2.5},
                  {3, 2.75, 2.5},
                  {2, 1.75, 1.5},
                  {2, 1.75, 2.5},
                  {3, 2.75, 1.5},
                  {4, 2.75, 2.5},
                  {3, 1.75, 1.5},
                  {3, 1.75, 2.5}},
                 {{0, 1, 2},
                  {3, 0, 2},
                  {3, 1, 0},
                  {1, 4, 2},
                  {3, 2, 4},
                  {3, 4, 1},
                  {5, 2, 6},
                  {7, 5, 6},
                  {7, 2, 5},
                  {2, 8, 6},
                  {7, 6, 8},
                  {7, 8, 2}}};
  const Solid result = Solid(test::tetrahedron({0, 0, 0}, {3, 2, 0}, {3, 0, 0}, {3, 3, 3})) - Solid(two);
  CHECK(strata::check(result.exact_mesh()).empty());
}

TEST_CASE("an edge on a face, from outside", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {4, 4, 4}));
  const Solid b(test::tetrahedron({1, 2, 4}, {3, 2, 4}, {2, 3, 5}, {2, 1, 5}));
  const Solid u = a | b;
  CHECK(topology(u.exact_mesh()).non_manifold_edges == 2);  // the diagonal of the top side crosses it
  CHECK(u.volume() == a.volume() + b.volume());
  CHECK((a & b).is_empty());
}

TEST_CASE("edges that cross in a point", "[csg][degenerate]") {
  const Solid a(test::tetrahedron({0, 2, 0}, {4, 2, 0}, {2, 0, -2}, {2, 4, -2}));
  const Solid b(test::tetrahedron({2, 0, 0}, {2, 4, 0}, {4, 2, 2}, {0, 2, 2}));
  const Solid u = a | b;
  CHECK(topology(u.exact_mesh()).non_manifold_vertices == 1);
  CHECK(u.volume() == a.volume() + b.volume());
  CHECK((a & b).is_empty());
}

TEST_CASE("an edge that passes through a vertex of the other operand", "[csg][degenerate]") {
  const Solid a(box({0, 0, 0}, {2, 2, 2}));
  const Solid b(test::tetrahedron({-1, 1, 2}, {3, 3, 2}, {-1, 3, 4}, {-1, 3, 0}));
  CHECK((a | b).volume() + (a & b).volume() == a.volume() + b.volume());
  CHECK((a - b).volume() + (a & b).volume() == a.volume());
}

TEST_CASE("octahedra through one another meet in edges and in faces", "[csg][degenerate]") {
  const Solid a(test::octahedron({0, 0, 0}, 2)), b(test::octahedron({1, 1, 0}, 2)), c(test::octahedron({1, 0, 1}, 2));
  const Solid all[] = {a, b, c};
  const Solid u = union_(all), i = intersection(all);
  CHECK(u.volume() ==
        a.volume() + b.volume() + c.volume() - (a & b).volume() - (b & c).volume() - (a & c).volume() + i.volume());
}

TEST_CASE("n operands through one point", "[csg][degenerate]") {
  std::vector<Solid> all;
  for (int i = 0; i < 8; ++i) {
    const double x = i & 1, y = i >> 1 & 1, z = i >> 2 & 1;
    all.emplace_back(box({x - 1, y - 1, z - 1}, {x, y, z}));
  }
  const Solid u = union_(all);
  CHECK(u == Solid(box({-1, -1, -1}, {1, 1, 1})));
  CHECK(intersection(all).is_empty());
  CHECK(symmetric_difference(all) == u);
}

// Catches: a corner on the surface of an operand taken for one inside it, because a face there lies inside.
TEST_CASE("faces on both sides of an operand's vertex", "[csg][degenerate]") {
  const Mesh inner = test::tetrahedron({1, 1, 1}, {.5, .5, .25}, {.25, .5, .5}, {.5, .25, .5});
  const Mesh outer = test::tetrahedron({1, 1, 1}, {1.5, 1.5, 1.75}, {1.5, 1.75, 1.5}, {1.75, 1.5, 1.5});
  Mesh both = inner;
  std::vector<std::uint32_t> number;  // in both; the vertex in common is one
  for (const Vertex& v : outer.vertices) {
    const auto there = std::find(inner.vertices.begin(), inner.vertices.end(), v);
    number.push_back(static_cast<std::uint32_t>(there == inner.vertices.end() ? both.vertices.size()
                                                                              : there - inner.vertices.begin()));
    if (there == inner.vertices.end()) both.vertices.push_back(v);
  }
  for (const Triangle& t : outer.triangles) both.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  REQUIRE(both.vertices.size() == 7);
  const Solid hourglass(both), inside(box({.3, .3, .3}, {.6, .6, .6})), outside(box({1.4, 1.4, 1.4}, {1.6, 1.6, 1.6}));
  REQUIRE(hourglass.volume() > 0);
  const Solid all[] = {hourglass, unit(), inside, outside};
  CHECK(union_(all) == (unit() | Solid(outer) | outside));
  CHECK(difference(all) == (Solid(outer) - outside));
}

TEST_CASE("needles whose tips are on a face, an ulp above and an ulp below", "[csg][degenerate]") {
  std::vector<Solid> all{Solid(box({0, 0, 0}, {8, 8, 1}))};
  Solid sum = all[0], rest = all[0];
  for (int i = 0; i < 6; ++i) {
    const double x = 1 + i, top = i % 3 == 0 ? 1 : std::nextafter(1, i % 3 == 1 ? 2 : 0);
    all.emplace_back(test::tetrahedron({x, 1, -1}, {x + .5, 1, -1}, {x, 1.5, -1}, {x + .1, 1.1, top}));
    sum = sum | all.back();
    rest = rest - all.back();
  }
  CHECK(union_(all) == sum);
  CHECK(difference(all) == rest);
}

TEST_CASE("solids of many sizes about one corner, at any scale", "[csg][degenerate]") {
  for (const double scale : {1.0, 0x1p-1000, 0x1p900}) {
    CAPTURE(scale);
    std::vector<Solid> all;
    Solid sum, odd, common;
    for (int k = 1; k < 7; ++k) {
      Mesh m =
          k % 2 == 1 ? box({0, 0, 0}, {1. * k, 1. * k, 1. * k}) : test::octahedron({k * .5, k * .5, k * .5}, k * .75);
      for (Vertex& v : m.vertices)
        for (double& x : v) x *= scale;
      all.emplace_back(m);
      sum = sum | all.back();
      odd = odd ^ all.back();
      common = k == 1 ? all.back() : common & all.back();
    }
    CHECK(union_(all) == sum);
    CHECK(symmetric_difference(all) == odd);
    CHECK(intersection(all) == common);
  }
}

TEST_CASE("a gap of one ulp stays a gap, an overlap of one ulp an overlap", "[csg][degenerate]") {
  const Solid a = unit();
  const Solid apart(box({std::nextafter(1.0, 2.0), 0, 0}, {2, 1, 1})),
      into(box({std::nextafter(1.0, 0.0), 0, 0}, {2, 1, 1}));
  CHECK(topology((a | apart).exact_mesh()).components == 2);
  CHECK((a & apart).is_empty());
  CHECK((a & into).volume() == Rational(1) - to_rational(std::nextafter(1.0, 0.0)));
}

TEST_CASE("results at the ends of the range of doubles", "[csg][degenerate]") {
  for (const double s : {1e-300, 1e-200, 1e150}) {
    CAPTURE(s);
    const Solid a(box({0, 0, 0}, {s, s, s})), b(box({s / 2, s / 2, s / 2}, {2 * s, 2 * s, 2 * s}));
    const Rational cube = to_rational(s) * to_rational(s) * to_rational(s);
    CHECK((a & b).volume() == cube / 8);
    CHECK((a | b).volume() + (a & b).volume() == a.volume() + b.volume());
  }
  const Solid thin(box({0, 0, 0}, {1e300, 1, 1e-300})), post(box({1, .25, -1}, {2, .75, 1}));
  CHECK((thin & post).volume() == Rational(1, 2) * to_rational(1e-300));
}

TEST_CASE("empty operands and empty results", "[csg][degenerate]") {
  const Solid a = unit(), nothing;
  CHECK((a | nothing) == a);
  CHECK((nothing | a) == a);
  CHECK((a & nothing).is_empty());
  CHECK((a - nothing) == a);
  CHECK((nothing - a).is_empty());
  CHECK((a ^ nothing) == a);
  CHECK((nothing | nothing).is_empty());
}

// Catches: a tolerance anywhere. The rims of the two discs cross hundreds of times within a step of doubles.
TEST_CASE("prisms of 100 sides, a step of doubles apart in size, share a plane", "[csg][degenerate]") {
  const auto prism = [](double radius, double orientation, double bottom) {
    constexpr std::uint32_t n = 100;
    Mesh mesh;
    for (const double z : {bottom, bottom + 1})
      for (std::uint32_t i = 0; i < n; ++i) {
        const double t = orientation + 2 * std::numbers::pi * i / n;
        mesh.vertices.push_back({radius * std::cos(t), radius * std::sin(t), z});
      }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      mesh.triangles.insert(mesh.triangles.end(), {{i, j, n + j}, {i, n + j, n + i}});
      if (i != 0 && j != 0) mesh.triangles.insert(mesh.triangles.end(), {{0, j, i}, {n, n + i, n + j}});
    }
    return Solid(mesh);
  };
  const Solid a = prism(1, 0, 0), b = prism(std::nextafter(1.0, 2.0), 1e-9, 1);
  const Solid both = a | b;
  CHECK(both.volume() == a.volume() + b.volume());
  CHECK((a & b).is_empty());
  CHECK((both - b) == a);
  CHECK(both.canonical().facet_count() > 202);  // and slivers of the plane they share
}

TEST_CASE("a cube of size 1e-200 stands on one of size 1e200", "[csg][degenerate]") {
  const double huge = 1e200, tiny = 1e-200;
  const Solid a(box({-huge, -huge, 0}, {huge, huge, huge})), b(box({-tiny, -tiny, -tiny}, {tiny, tiny, 0}));
  const Solid both = a | b;
  CHECK(both.volume() == a.volume() + b.volume());
  CHECK(both.canonical().facet_count() == 11);
  CHECK((both - a) == b);
}

TEST_CASE("150 teeth on a plate make a comb", "[csg][degenerate]") {
  const Solid plate(box({0, 0, 0}, {300, 1, 1}));
  Mesh teeth;
  for (int i = 0; i < 150; ++i) test::append(teeth, box({2.0 * i, 0, 1}, {2.0 * i + 1, 1, 2}));
  const Solid comb = plate | Solid(teeth);
  // Front and back; bottom, and top with gaps; left and right sides of teeth, and of the plate.
  check(comb, {450, 2 * 450 + 300 + 300 + 2 * 151, 1, 2, 0, 0});
  CHECK(comb.canonical().facet_count() == 604);
}
