#include "core/round/surface_distance.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "support/random.h"

using namespace strata;

namespace {

constexpr double far_away = 1000;

/// Bounds on how far the triangles of a mesh are from a surface, where nothing is known but that they are not far away.
std::vector<double> distances(const ExactMesh& surface, const Mesh& mesh, double known = far_away) {
  std::vector<double> result(mesh.triangles.size(), known);
  tighten_distances(NearestMesh::of(surface), mesh, 0, {}, result);
  return result;
}

double distance_of_one(const ExactMesh& surface, const std::array<Vertex, 3>& t, double known = far_away) {
  return distances(surface, {{t[0], t[1], t[2]}, {{0, 1, 2}}}, known).front();
}

/// [0, 1] x [0, 1], divided into squares, at the heights of a function.
template <class Height>
Mesh terrain(std::uint32_t squares, const Height& height) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= squares; ++i)
    for (std::uint32_t j = 0; j <= squares; ++j)
      mesh.vertices.push_back({double(i) / squares, double(j) / squares, height(i, j)});
  for (std::uint32_t i = 0; i < squares; ++i)
    for (std::uint32_t j = 0; j < squares; ++j) {
      const std::uint32_t a = i * (squares + 1) + j, b = a + squares + 1;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({b, b + 1, a + 1});
    }
  return mesh;
}

ExactMesh plate(std::uint32_t squares) {
  return {terrain(squares, [](auto, auto) { return 0.0; }), {}};
}

/// The distance from some points of each triangle, in the maximum norm.
double least_distance(const Mesh& surface, const Vertex& p) {
  constexpr int steps = 40;
  double least = far_away;
  for (const Triangle& t : surface.triangles)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        double largest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double at = (surface.vertices[t[0]][k] * i + surface.vertices[t[1]][k] * j +
                             surface.vertices[t[2]][k] * (steps - i - j)) /
                            steps;
          largest = std::max(largest, std::abs(at - p[k]));
        }
        least = std::min(least, largest);
      }
  return least;
}

}  // namespace

TEST_CASE("a triangle above a plate is as far from it as its highest corner", "[round][distance]") {
  for (const std::uint32_t squares : {1, 2, 7}) {
    CHECK(distance_of_one(plate(squares), {{{0.1, 0.2, 1e-6}, {0.9, 0.3, 2e-6}, {0.4, 0.8, 3e-6}}}) ==
          Approx(3e-6).epsilon(1e-12));
    CHECK(distance_of_one(plate(squares), {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) < 1e-25);
    CHECK(distance_of_one(plate(squares), {{{1, 0, 0}, {0, 0.5, 0}, {0, 1, 0}}}) < 1e-25);
  }
}

TEST_CASE("what sticks out beyond a surface is measured from its border", "[round][distance]") {
  const std::array<Vertex, 3> beyond{{{0.5, 0.25, 0}, {1 + 1e-6, 0.5, 0}, {0.5, 0.75, 0}}};
  CHECK(distance_of_one(plate(1), beyond) == Approx(1e-6).epsilon(1e-9));
  CHECK(distance_of_one(plate(4), beyond) == Approx(1e-6).epsilon(1e-9));
  const std::array<Vertex, 3> beside{{{2, 0.25, 0}, {3, 0.5, 0}, {2, 0.75, 0}}};
  CHECK(distance_of_one(plate(1), beside) == Approx(2));
  CHECK(distance_of_one(plate(1), beside, 0.5) == 0.5);  // what was known stays where it is better
}

TEST_CASE("a triangle that stands on a surface is as far as its height", "[round][distance]") {
  CHECK(distance_of_one(plate(3), {{{0.1, 0.5, 0}, {0.9, 0.5, 0}, {0.5, 0.5, 0.25}}}) == Approx(0.25));
  CHECK(distance_of_one(plate(3), {{{0.1, 0.5, 0}, {0.1, 0.5, 0}, {0.5, 0.5, 0.25}}}) == Approx(0.25));
}

TEST_CASE("bounds at small distances and large coordinates count the last bits", "[round][distance]") {
  // 2^-53 of the size is half a unit of a double: a bound in doubles would be units larger.
  Mesh surface = plate(3).mesh;
  std::array<Vertex, 3> t{{{0.125, 0.25, 0}, {0.875, 0.25, 0}, {0.5, 0.75, 0}}};
  for (Vertex& v : surface.vertices) v = {v[0], v[1], v[0] + v[1]};
  for (Vertex& v : t) v = {v[0], v[1], std::nextafter(v[0] + v[1], 4)};
  CHECK(distance_of_one({surface, {}}, t) <= 0x1p-52 * (1 + 1e-9));
  // A vertex that is not its nearest double may be half a unit off.
  const ExactMesh off{surface, {{0, {Rational(1, 3) - Rational(1, 3), 0, 0}}}};
  CHECK(distance_of_one(off, t) <= 0x1p-52 * 1.5);
}

TEST_CASE("bounds are as good at huge and tiny coordinates", "[round][distance]") {
  for (const int exponent : {1020, -1000, -1060}) {
    const auto scaled = [&](const Vertex& v) -> Vertex {
      return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
    };
    Mesh surface = plate(2).mesh;
    for (Vertex& v : surface.vertices) v = scaled(v);
    const double height = 0x1p-10;
    const double d =
        distance_of_one({surface, {}}, {scaled({0.25, 0.25, height}), scaled({0.5, 0.25, 0}), scaled({0.25, 1, 0})},
                        std::ldexp(1.0, exponent));
    CHECK(d >= std::ldexp(height, exponent));
    CHECK(d <= std::ldexp(1.01 * height, exponent) + 0x1p-1074);
  }
}

TEST_CASE("no point of a triangle is farther from a surface than its bound", "[round][distance][property]") {
  test::Random random(31);
  for (int n = 0; n < 60; ++n) {
    const double rough = std::ldexp(1.0, random.between(-12, 0));
    const Mesh surface = terrain(3, [&](auto, auto) { return rough * random.unit(); });
    const auto place = [&]() -> Vertex {
      return {1.2 * random.unit() - 0.1, 1.2 * random.unit() - 0.1, rough * (2 * random.unit() - 0.5)};
    };
    const std::array<Vertex, 3> t{place(), place(), place()};
    const double bound = distance_of_one({surface, {}}, t);
    double largest = 0;
    for (const Vertex& corner : t) largest = std::max(largest, least_distance(surface, corner));
    for (int k = 0; k < 100; ++k) {
      const double a = random.unit(), b = random.unit() * (1 - a);
      Vertex p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = t[0][i] + a * (t[1][i] - t[0][i]) + b * (t[2][i] - t[0][i]);
      largest = std::max(largest, least_distance(surface, p));
    }
    INFO(n);
    constexpr double between_samples = 1.0 / 3 / 40;
    CHECK(largest <= bound + between_samples);
    CHECK(bound <= 2 * largest + between_samples);
  }
}

TEST_CASE("what would take too long is measured from one face", "[round][distance]") {
  test::Random random(5);
  Mesh spread;  // faces of all sizes, everywhere
  for (std::uint32_t f = 0; f < 400; ++f) {
    for (int k = 0; k < 3; ++k) {
      const double size = std::ldexp(1.0, random.between(-60, 0));
      spread.vertices.push_back({size * random.unit(), size * random.unit(), size * random.unit()});
    }
    spread.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  CHECK(distance_of_one({spread, {}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}}) < 2);
}

TEST_CASE("a surface of numbers that overflow is measured from one face", "[round][distance]") {
  const Mesh surface{{{0, 0, 0}, {0x1p1023, 0, 0}, {0, 0x1p1023, 0x1p1020}}, {{0, 1, 2}}};
  const double d = distance_of_one({surface, {}}, {{{0, 0, 0}, {0x1p-1000, 0, 0}, {0, 0x1p-1000, 0}}}, 1);
  CHECK(d >= 0x1p-1004);
  CHECK(d <= 1);
}

TEST_CASE("bounds that are enough stay as they are", "[round][distance]") {
  std::vector<double> known{0.5, 2};
  const Mesh mesh{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 1, 2}}};
  const ExactMesh surface = plate(1);
  tighten_distances(NearestMesh::of(surface), mesh, 1, {}, known);
  CHECK(known[0] == 0.5);
  CHECK(known[1] == Approx(1));
}
