#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "strata/combine.h"
#include "strata/solid.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Mesh scaled(Mesh mesh, double by) {
  for (Vertex& v : mesh.vertices)
    for (double& x : v) x *= by;
  return mesh;
}

/// Each coordinate stays, or goes one unit in the last place outwards or inwards.
Mesh jittered(Mesh mesh, unsigned seed) {
  std::mt19937 random(seed);
  for (Vertex& v : mesh.vertices)
    for (double& x : v)
      if (const auto k = random() % 3; k != 0) x = std::nextafter(x, k == 1 ? std::copysign(9.0, x) : 0.0);
  return mesh;
}

}  // namespace

// Around the scale at which products of areas and coordinates overflow, cells cease to be apart. Seen to fail: a
// comparison that takes what is not a number for a gap.
TEST_CASE("surfaces near each other are combined alike at all scales", "[csg][property]") {
  const Mesh a = test::icosphere({0, 0, 0}, 1, 3), b = test::icosphere({.01, .002, .001}, 1, 3);
  const auto united = [](const Mesh& m, const Mesh& n) {
    return combine(Operation::union_, std::array<MeshView, 2>{m, n}).mesh;
  };
  const Mesh expected = united(a, b);
  const int exponent = GENERATE(-340, -320, 320, 330, 333, 334, 335, 341, 345);
  const double by = std::ldexp(1, exponent);
  const Mesh result = united(scaled(a, by), scaled(b, by));
  CHECK(result.triangles == expected.triangles);
  CHECK(result.vertices == scaled(expected, by).vertices);
}

// Contact, crossings and gaps of one unit in the last place in every cell. Seen to fail: gaps without the bound on
// errors.
TEST_CASE("Booleans of surfaces an ulp apart obey the laws of sets", "[csg][property]") {
  const Mesh ball = test::icosphere({0.1, 0.2, 0.3}, 1, 3);
  const Solid a(ball), b(jittered(ball, GENERATE(range(1u, 6u))));
  CHECK(((a - b) | (a & b)) == a);
  CHECK(((a ^ b) | (a & b)) == (a | b));
  CHECK((a - b).volume() + (a & b).volume() == a.volume());
}
