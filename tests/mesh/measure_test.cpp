#include "strata/measure.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/exact/big_integer.h"
#include "core/exact/scaled_root.h"
#include "core/exact/vector.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/split_vertices.h"
#include "shapes.h"

using namespace strata;
using namespace strata::shapes;

namespace {

Rational volume_by_rationals(const ExactMesh& mesh) {
  Rational sum = 0;
  for (const Triangle& t : mesh.mesh.triangles) {
    const RationalPoint a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

/// Every coordinate divided by three, exactly.
ExactMesh in_thirds(const Mesh& mesh) {
  ExactMesh result{mesh, {}};
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    RationalPoint p;
    for (int i = 0; i < 3; ++i) {
      p[i] = to_rational(mesh.vertices[v][i]) / 3;
      result.mesh.vertices[v][i] = to_nearest_double(p[i]);
    }
    result.exact.push_back({v, p});
  }
  return result;
}

/// The area of the first triangle, in units of 4^size.
double scaled_area(ExactMeshView mesh, int size) {
  const auto side = [&](std::uint32_t i) {
    RationalPoint u;
    for (std::size_t k = 0; k < 3; ++k)
      u[k] = (mesh.position(i)[k] - mesh.position(0)[k]) * to_rational(std::ldexp(1.0, -size));
    return u;
  };
  const RationalPoint normal = cross(side(1), side(2));
  const Rational squared = dot(normal, normal);
  const int half = -static_cast<int>(binary_size(squared) / 2);  // a square about 1 has a root that is a double
  return std::ldexp(std::sqrt(to_nearest_double(
                        Rational(squared * Rational(half > 0 ? Integer(1) << (2 * half) : Integer(1),
                                                    half > 0 ? Integer(1) : Integer(1) << (-2 * half))))),
                    -half) /
         2;
}

}  // namespace

TEST_CASE("the volume of a box is exact and signed", "[mesh]") {
  CHECK(volume({box({-1, 0, 2}, {1, 3, 2.5}), {}}) == 3);
  CHECK(volume({flipped(box({-1, 0, 2}, {1, 3, 2.5})), {}}) == -3);
  CHECK(volume({corner_tetrahedron(), {}}) == Rational(1, 6));
  CHECK(volume({}) == 0);
}

TEST_CASE("the volume is exact for magnitudes from the smallest to the largest double", "[mesh]") {
  const double tiny = 4.9406564584124654e-324;
  const double huge = 1.7976931348623157e308;
  const Vertex corners[] = {{tiny, tiny, tiny}, {huge, huge, huge}, {1e-300, 1e300, 1}, {-1e-310, -huge, tiny}};
  for (const Vertex& corner : corners) {
    const ExactMesh mesh{box({-tiny, -1, 0}, corner), {}};
    CHECK(volume(mesh) == volume_by_rationals(mesh));
  }
}

TEST_CASE("the volume of triangles at random equals a sum of rationals", "[mesh]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> fraction(-1, 1);
  std::uniform_int_distribution<int> exponent(-1000, 1000);
  ExactMesh mesh;
  for (std::uint32_t i = 0; i < 300; ++i) {
    Vertex v;
    for (double& x : v) x = std::ldexp(fraction(random), i < 200 ? exponent(random) : 0);
    mesh.mesh.vertices.push_back(v);
    if (i >= 2) mesh.mesh.triangles.push_back({i - 2, i - 1, i});
  }
  CHECK(volume(mesh) == volume_by_rationals(mesh));
}

TEST_CASE("the volume of closed meshes is that of prisms, for coordinates of all kinds", "[mesh][property]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> fraction(-1, 1);
  std::uniform_int_distribution<int> range(0, 3), wide(-1000, 1000), narrow(-8, 0);
  for (int round = 0; round < 300; ++round) {
    // Tetrahedra, which may overlap and be inside out; some with coordinates on no common lattice.
    Mesh mesh;
    const int kind = range(random), scale = wide(random);
    for (std::uint32_t i = 0; i < 40; i += 4) {
      for (int k = 0; k < 4; ++k) {
        Vertex v;
        for (double& x : v) {
          x = kind == 0 ? (fraction(random) < 0 ? -1 : 1) * (2 - 0x1p-52) : fraction(random);
          x = std::ldexp(x, kind == 3 ? wide(random) : scale + (kind == 2 ? narrow(random) : 0));
        }
        mesh.vertices.push_back(v);
      }
      for (const Triangle& t : {Triangle{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
        mesh.triangles.push_back({t[0] + i, t[1] + i, t[2] + i});
    }
    const ClosedVolume closed = volume_of_closed(ExactMeshView(mesh, {}));
    const Rational expected = volume_by_rationals({mesh, {}});
    REQUIRE(closed.exact == expected);
    REQUIRE(closed.nearest == to_nearest_double(expected));
  }
  CHECK(volume_of_closed({}).exact == Rational(0));
  const ExactMesh thirds = in_thirds(box({0, 0, 0}, {1, 1, 1}));
  CHECK(volume_of_closed(thirds).nearest == to_nearest_double(Rational(1, 27)));
  CHECK(volume_of_closed(thirds).exact == Rational(1, 27));
}

TEST_CASE("exact vertices take part in the volume with their exact places", "[mesh]") {
  CHECK(volume(in_thirds(box({0, 0, 0}, {1, 1, 1}))) == Rational(1, 27));
  ExactMesh mixed{box({0, 0, 0}, {1, 1, 1}), {}};
  mixed.mesh.vertices[7] = {1.0 / 3, 1, 1};
  mixed.exact = {{7, {Rational(1, 3), 1, 1}}};
  CHECK(volume(mixed) == volume_by_rationals(mixed));
}

TEST_CASE("the nearest volume is that of the fraction, whatever the places of rational vertices", "[mesh][property]") {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> numerator(-1000, 1000), denominator(1, 1000), exponent(0, 3);
  for (int round = 0; round < 200; ++round) {
    ExactMesh mesh{globe(4), {}};
    // From spheres to plates far thinner than what two doubles can tell, near the origin and far from it.
    const Rational thickness(1, Integer(1) << (round % 5 * 40));
    const Rational distance = round % 3 == 0 ? Rational(0) : Rational(Integer(1) << (round % 7 * 10));
    for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
      RationalPoint p;
      for (int i = 0; i < 3; ++i) {
        p[i] = to_rational(mesh.mesh.vertices[v][i]);
        if (round % 4 != 0 || v % 3 == 0) p[i] += Rational(numerator(random), denominator(random) * 10000);
      }
      p[2] = p[2] * thickness + distance;
      bool is_rounded = false;
      for (int i = 0; i < 3; ++i) {
        mesh.mesh.vertices[v][i] = to_nearest_double(p[i]);
        is_rounded = is_rounded || to_rational(mesh.mesh.vertices[v][i]) != p[i];
      }
      if (is_rounded) mesh.exact.push_back({v, p});
    }
    REQUIRE(nearest_volume(mesh) == to_nearest_double(volume_by_rationals(mesh)));
  }
  CHECK(nearest_volume(in_thirds(box({0, 0, 0}, {1, 1, 1}))) == to_nearest_double(Rational(1, 27)));
  CHECK(nearest_volume(in_thirds(scaled(box({0, 0, 0}, {1, 1, 1}), 1e-100))) > 0);
}

TEST_CASE("two doubles and a lattice decide the volume, for coordinates on it and beside it", "[mesh][property]") {
  std::mt19937_64 random(6);
  std::uniform_int_distribution<int> numerator(-1000, 1000), denominator(1, 1000), exponent(-60, 0), scale(-300, 300);
  for (int round = 0; round < 100; ++round) {
    ExactMesh mesh{globe(4), {}};
    const int size = scale(random);
    for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
      RationalPoint p;
      bool is_rounded = false;
      for (int i = 0; i < 3; ++i) {
        double& x = mesh.mesh.vertices[v][i];
        x = std::ldexp(round % 2 == 0 && v % 5 == 0 ? std::ldexp(x, exponent(random)) : x, size);
        p[i] = to_rational(x);
        if (round % 3 != 0)
          p[i] += to_rational(std::ldexp(1.0, size)) * Rational(numerator(random), denominator(random) * 100000);
        x = to_nearest_double(p[i]);
        is_rounded = is_rounded || to_rational(x) != p[i];
      }
      if (is_rounded) mesh.exact.push_back({v, p});
    }
    for (const Closed closed : {Closed::unknown, Closed::known}) {
      const auto decided = decided_volume(mesh.mesh, SplitVertices(mesh), closed, {});
      REQUIRE(decided.has_value());
      REQUIRE(*decided == to_nearest_double(volume_by_rationals(mesh)));
    }
  }
}

TEST_CASE("a mesh that is not rounded to nearest has a volume", "[mesh]") {
  ExactMesh mesh{scaled(box({0, 0, 0}, {1, 1, 1}), 1e-100), {}};
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) {
    RationalPoint p = mesh.position(v);
    for (Rational& x : p) x *= to_rational(1e150);
    mesh.exact.push_back({v, p});
  }
  CHECK(nearest_volume(mesh) == Approx(1e150));
}

TEST_CASE("the volume is not decided where two doubles cannot tell between two doubles", "[mesh]") {
  // A box whose volume lies between two doubles but for what a rational vertex adds, far below the rest of two doubles.
  ExactMesh mesh{box({0, 0, 0}, {1, 1, 1}), {}};
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v)
    if (mesh.mesh.vertices[v][0] == 1)
      mesh.exact.push_back({v, {1 + Rational(1, Integer(1) << 53), mesh.position(v)[1], mesh.position(v)[2]}});
  CHECK(decided_volume(mesh.mesh, SplitVertices(mesh), Closed::known, {}) == std::nullopt);
  CHECK(nearest_volume(mesh) == 1);  // to even
  for (ExactVertex& e : mesh.exact) e.position[0] += Rational(1, Integer(1) << 300);
  CHECK(decided_volume(mesh.mesh, SplitVertices(mesh), Closed::known, {}) == std::nullopt);
  CHECK(nearest_volume(mesh) == 1 + 0x1p-52);
}

TEST_CASE("the area of triangles between rational vertices that round to one double is right", "[mesh]") {
  ExactMesh mesh{{{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}, {}};
  const Rational tiny(1, Integer(1) << 200);
  mesh.exact = {{1, {1 + tiny, 0, 0}}, {2, {1, tiny, 0}}};
  mesh.mesh.vertices[2][1] = to_nearest_double(tiny);
  CHECK(area(mesh) == std::ldexp(1.0, -401));
  // Nearer to each other than what two doubles leave out.
  const Rational far(1, Integer(3) << 55), near(1, Integer(3) << 108);
  mesh.exact = {{0, {1 + far, 0, 0}}, {1, {1 + far + near, 0, 0}}, {2, {1 + far, near, 0}}};
  mesh.mesh.vertices[2] = {1, to_nearest_double(near), 0};
  CHECK(area(mesh) == to_nearest_double(Rational(near * near / 2)));
}

TEST_CASE("the area is right to the last bits, for slivers and extreme magnitudes too", "[mesh]") {
  CHECK(area({box({0, 0, 0}, {1, 2, 3}), {}}) == 22);
  CHECK(area({scaled(box({0, 0, 0}, {1, 1, 1}), 1e150), {}}) == Approx(6e300).epsilon(1e-15));
  CHECK(area({scaled(box({0, 0, 0}, {1, 1, 1}), 1e-150), {}}) == Approx(6e-300).epsilon(1e-15));
  const double d = std::ldexp(1.0, -52);  // a sliver along (1, 1, 1) whose height is lost in doubles
  const Mesh sliver{{{0, 0, 0}, {1, 1, 1}, {1 + d, 1, 1}}, {{0, 1, 2}}};
  CHECK(area({sliver, {}}) == Approx(d * std::sqrt(2.0) / 2).epsilon(1e-15));
  CHECK(area(in_thirds(box({0, 0, 0}, {1, 1, 1}))) == Approx(6.0 / 9).epsilon(1e-15));
}

TEST_CASE("the area of triangles of all angles and magnitudes is right to a few units", "[mesh][property]") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> fraction(-1, 1);
  std::uniform_int_distribution<int> exponent(-200, 200), narrow(-30, 0), wide(-600, 0);
  for (int round = 0; round < 20000; ++round) {
    const int size = exponent(random), thin = round % 2 == 0 ? 0 : narrow(random);
    Mesh mesh{{}, {{0, 1, 2}}};
    for (int i = 0; i < 3; ++i)
      mesh.vertices.push_back({std::ldexp(fraction(random), size), std::ldexp(fraction(random), size + thin),
                               std::ldexp(fraction(random), size + thin)});
    if (round % 3 == 0) {  // a side far shorter than the others
      mesh.vertices[0] = {};
      const int shorter = wide(random);
      for (double& x : mesh.vertices[1 + round % 2]) x = std::ldexp(x, shorter);
    }
    const double unit = std::ldexp(1.0, 2 * size);
    REQUIRE(std::abs(area({mesh, {}}) / unit - scaled_area({mesh, {}}, size)) <=
            scaled_area({mesh, {}}, size) * (7 * 0x1p-52));
  }
  const double tiny = std::ldexp(1.0, -550), large = std::ldexp(1.0, 250);
  const Mesh thin{{{0, 0, 0}, {3 * tiny, 5 * tiny, 7 * tiny}, {3 * large, 5 * large, std::nextafter(7, 8) * large}},
                  {{0, 1, 2}}};
  CHECK(area({thin, {}}) == Approx(scaled_area({thin, {}}, 0)).epsilon(1e-15).scale(0));
}

TEST_CASE("the area of triangles with rational vertices is right to a few units, however small these are",
          "[mesh][property]") {
  std::mt19937_64 random(10);
  std::uniform_int_distribution<int> numerator(-1000, 1000), denominator(1, 1000), smaller(0, 70);
  for (int round = 0; round < 5000; ++round) {
    ExactMesh mesh{{{}, {{0, 1, 2}}}, {}};
    const Rational size(1, Integer(1) << smaller(random));
    RationalPoint middle;
    for (Rational& x : middle) x = Rational(numerator(random), denominator(random));
    for (std::uint32_t v = 0; v < 3; ++v) {
      RationalPoint p = middle;
      for (Rational& x : p) x += size * Rational(numerator(random), denominator(random));
      mesh.mesh.vertices.push_back({to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])});
      if (mesh.position(v) != p) mesh.exact.push_back({v, p});
    }
    const double expected = scaled_area(mesh, 0);
    REQUIRE(std::abs(area(mesh) - expected) <= expected * (9 * 0x1p-52));
  }
}

TEST_CASE("a box is one component of Euler characteristic two, whether its vertices are shared or not", "[mesh]") {
  for (const Mesh& mesh : {box({0, 0, 0}, {1, 1, 1}), shattered(box({0, 0, 0}, {1, 1, 1}))}) {
    const Topology facts = topology({mesh, {}});
    CHECK(facts.components == 1);
    CHECK(facts.euler == 2);
    CHECK(facts.non_manifold_edges == 0);
    CHECK(facts.non_manifold_vertices == 0);
    CHECK(facts.open_edges == 0);
  }
}

TEST_CASE("minus zero and zero are one coordinate", "[mesh]") {
  const Mesh mesh = joined(box({-1, -1, -1}, {0, 0, 0}), box({-0.0, -0.0, -0.0}, {1, 1, 1}));
  CHECK(topology({mesh, {}}).components == 1);
}

TEST_CASE("boxes that share an edge or a vertex are not manifold there", "[mesh]") {
  const Mesh cube = box({0, 0, 0}, {1, 1, 1});
  const Topology edge = topology({joined(cube, moved(cube, {1, 1, 0})), {}});
  CHECK(edge.components == 1);
  CHECK(edge.non_manifold_edges == 1);
  CHECK(edge.non_manifold_vertices == 2);
  CHECK(edge.euler == 14 - 35 + 24);
  const Topology vertex = topology({joined(cube, moved(cube, {1, 1, 1})), {}});
  CHECK(vertex.non_manifold_edges == 0);
  CHECK(vertex.non_manifold_vertices == 1);
  CHECK(vertex.euler == 3);
  const Topology apart = topology({joined(cube, moved(cube, {2, 0, 0})), {}});
  CHECK(apart.components == 2);
  CHECK(apart.euler == 4);
}

TEST_CASE("counts of edges and fans are those of all pairs of triangles", "[mesh][property]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    // Few vertices, so that edges of one, two, three uses in any direction, and vertices of several fans, are common.
    const std::uint32_t count = 4 + seed % 9;
    Mesh mesh;
    for (std::uint32_t v = 0; v < count; ++v) mesh.vertices.push_back({double(v), double(v * v), double(v * v * v)});
    if (seed % 2 == 0) mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    for (unsigned t = 0; t < seed % 17; ++t) {
      const Triangle added{std::uint32_t(random() % count), std::uint32_t(random() % count),
                           std::uint32_t(random() % count)};
      if (!repeats_vertex(added)) mesh.triangles.push_back(added);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::size_t, bool>>> uses;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
        uses[std::minmax(a, b)].emplace_back(t, a < b);
      }
    Topology expected;
    for (const auto& [edge, list] : uses) {
      expected.non_manifold_edges += list.size() > 2;
      std::int64_t net = 0;
      for (const auto& use : list) net += use.second ? 1 : -1;
      expected.open_edges += net != 0;
    }
    std::set<std::uint32_t> used;
    for (std::uint32_t v = 0; v < count; ++v) {
      std::map<std::size_t, std::size_t> fan;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), v) > 0) fan[t] = t;
      if (fan.empty()) continue;
      used.insert(v);
      for (const auto& [edge, list] : uses)
        if ((edge.first == v || edge.second == v) && list.size() == 2) {
          const std::size_t from = fan[list[0].first], to = fan[list[1].first];
          for (auto& [t, f] : fan)
            if (f == from) f = to;
        }
      std::set<std::size_t> fans;
      for (const auto& [t, f] : fan) fans.insert(f);
      expected.non_manifold_vertices += fans.size() > 1;
    }
    const Topology found = topology({mesh, {}});
    CHECK(found.euler == std::int64_t(used.size() + mesh.triangles.size()) - std::int64_t(uses.size()));
    CHECK(found.non_manifold_edges == expected.non_manifold_edges);
    CHECK(found.non_manifold_vertices == expected.non_manifold_vertices);
    CHECK(found.open_edges == expected.open_edges);
  }
}

TEST_CASE("a missing triangle opens three edges", "[mesh]") {
  Mesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  CHECK(topology({mesh, {}}).open_edges == 3);
  CHECK(topology({mesh, {}}).euler == 1);
  CHECK(topology({}).components == 0);
}

TEST_CASE("exact vertices that round to the same doubles stay apart", "[mesh]") {
  ExactMesh mesh{{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 3}, {1, 3, 2}}}, {}};
  CHECK(topology(mesh).open_edges == 0);
  mesh.exact = {{1, {Rational(1, Integer(1) << 2000), 0, 0}}};
  CHECK(topology(mesh).open_edges == 4);
}

TEST_CASE("measures of a million triangles take well under a second", "[mesh][slow]") {
  const ExactMesh mesh{globe(800), {}};
  const auto start = std::chrono::steady_clock::now();
  const Rational v = volume(mesh);
  const auto middle = std::chrono::steady_clock::now();
  CHECK(topology(mesh).euler == 2);
  const auto end = std::chrono::steady_clock::now();
  WARN("volume " << std::chrono::duration<double>(middle - start).count() << " s, topology "
                 << std::chrono::duration<double>(end - middle).count() << " s");
  CHECK(to_nearest_double(v) == Approx(4.18879).epsilon(1e-4));
  CHECK(area(mesh) == Approx(12.56637).epsilon(1e-4));
}

TEST_CASE("the volume is exact where some coordinates are on the lattice of the largest, and some are not", "[mesh]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> fraction(-1, 1);
  for (const int size : {-1070, -1000, -300, 0, 300, 960, 1020}) {
    for (const int spread : {0, 5, 9, 30, 600}) {
      ExactMesh mesh;
      std::uniform_int_distribution<int> exponent(size - spread, size);
      for (std::uint32_t i = 0; i < 60; ++i) {
        mesh.mesh.vertices.push_back({});
        for (double& x : mesh.mesh.vertices.back()) x = std::ldexp(fraction(random), exponent(random));
        if (i >= 2) mesh.mesh.triangles.push_back({i - 2, i - 1, i});
      }
      CHECK(volume(mesh) == volume_by_rationals(mesh));
    }
  }
  const double huge = std::numeric_limits<double>::max();
  for (const Vertex& corner : {Vertex{huge, huge, huge}, Vertex{-huge, huge, -huge}, Vertex{huge, 1, huge / 512}})
    CHECK(volume({box({0, 0, 0}, corner), {}}) == volume_by_rationals({box({0, 0, 0}, corner), {}}));
}
