#include "extensions/convex/touching_faces.h"

#include <catch2/catch.hpp>
#include <optional>

#include "core/mesh/prepare.h"
#include "extensions/convex/convex_solid.h"
#include "extensions/convex/membership.h"
#include "extensions/convex/surface.h"
#include "strata/check.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace strata::convex {
namespace {

using test::Random;

ExactMesh touching(const Mesh& a, const Mesh& b) {
  return touching_faces(surface_of(test::exact(a)), surface_of(test::exact(b)));
}

/// Six times what a closed surface holds.
Rational six_volumes(const ExactMesh& mesh) {
  Rational sum = 0;
  for (const Triangle& t : mesh.mesh.triangles) {
    const RationalPoint p = mesh.position(t[0]), q = mesh.position(t[1]), r = mesh.position(t[2]);
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum;
}

/// A point inside a triangle, moved backwards by infinitely little.
NearPoint place_behind(const ExactMesh& mesh, const Triangle& t, int k) {
  const RationalPoint p = mesh.position(t[0]), q = mesh.position(t[1]), r = mesh.position(t[2]);
  NearPoint result;
  RationalPoint u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    result.p[i] = (p[i] + k * q[i] + k * k * r[i]) / (1 + k + k * k);
    u[i] = q[i] - p[i];
    v[i] = r[i] - p[i];
  }
  result.n = {u[2] * v[1] - u[1] * v[2], u[0] * v[2] - u[2] * v[0], u[1] * v[0] - u[0] * v[1]};
  return result;
}

}  // namespace

// Catches: faces that are missing, turned over or there twice.
TEST_CASE("convex solids touch in the boundary of their sum", "[convex][minkowski]") {
  const auto box = [](double x, double y, double z) { return test::box({0, 0, 0}, {x, y, z}); };
  const ExactMesh boxes = touching(box(1, 2, 3), box(4, 5, 6));
  CHECK(six_volumes(boxes) == 6 * 5 * 7 * 9);  // nothing more to close: parallelograms of parallel edges have no area
  const ExactMesh balls = touching(test::icosphere({0, 0, 0}, 1, 2), test::icosphere({3, 2, 1}, 2, 1));
  CHECK(chain_is_closed(balls.mesh));
  CHECK(six_volumes(balls) > 6 * 4 * 20);
}

// Catches: faces where both cross near by, which would tell nothing of what is behind them.
TEST_CASE("the sum is just behind every touching face", "[convex][minkowski][property]") {
  std::size_t asked = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const ExactMesh a = test::exact(test::lattice_solid(random)), b = test::exact(test::lattice_solid(random));
    const Surface of_a = surface_of(a), of_b = surface_of(b);
    const ExactMesh faces = touching_faces(of_a, of_b);
    const SumMembership membership(a, of_a, &b, of_b, nullptr, Monitor());
    for (std::size_t f = 0; f < faces.mesh.triangles.size(); f += 1 + faces.mesh.triangles.size() / 20) {
      Side side = Side::unknown;
      for (int k = 1; k < 64 && side == Side::unknown; ++k)
        side = membership.side(place_behind(faces, faces.mesh.triangles[f], k));
      REQUIRE(side == Side::in);
      ++asked;
    }
  }
  CHECK(asked > 500);
}

// Catches: faces at which there is never room, which cost time only.
TEST_CASE("reflex edges and vertices that something rises from have no touching faces", "[convex][minkowski]") {
  const Mesh frame = test::box_with_hole(), cube = test::box({0, 0, 0}, {0.5, 0.5, 0.5});
  const std::size_t faces = touching(frame, cube).mesh.triangles.size();
  CHECK(faces == 148);  // the whole convolution has 168
  CHECK(faces == touching(cube, frame).mesh.triangles.size());
}

}  // namespace strata::convex
