#include <catch2/catch.hpp>

#include "strata/mesh.h"

using namespace strata;

TEST_CASE("a vertex of an exact mesh is its rational, or else its doubles", "[mesh]") {
  ExactMesh mesh;
  mesh.mesh.vertices = {{0.5, 0, 0}, {1.0 / 3, 0, 0}, {-0.0, 2, 1e-300}};
  mesh.exact = {{1, {Rational(1, 3), 0, 0}}};
  CHECK(mesh.position(0) == RationalPoint{Rational(1, 2), 0, 0});
  CHECK(mesh.position(1) == RationalPoint{Rational(1, 3), 0, 0});
  CHECK(mesh.position(2) == RationalPoint{0, 2, to_rational(1e-300)});
}
