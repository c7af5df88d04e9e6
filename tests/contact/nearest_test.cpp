#include "extensions/contact/nearest.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "contact/parts.h"
#include "support/random.h"
#include "support/touching.h"

namespace strata::contact {
namespace {

using namespace test_parts;
using Kind = MeshFeature::Kind;

TEST_CASE("the distance of boxes is that of their nearest vertices, edges or faces", "[contact]") {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const Nearest vertices = nearest(a, box({2, 3, 4}, {5, 5, 5}));
  CHECK(vertices.squared == 1 + 4 + 9);
  CHECK(vertices.distance == std::sqrt(14.0));
  CHECK(vertices.on_a == RationalPoint{1, 1, 1});
  CHECK(vertices.on_b == RationalPoint{2, 3, 4});
  CHECK(vertices.feature_a.kind == Kind::vertex);
  CHECK(vertices.feature_b.kind == Kind::vertex);
  const std::array<double, 2> square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Nearest tip = nearest(a, Solid(test::pyramid(square, 5, {0.5, 0.25, 3})));
  CHECK(tip.squared == 4);
  CHECK(tip.on_a == RationalPoint{Rational(1) / 2, Rational(1) / 4, 1});
  CHECK(tip.feature_a.kind == Kind::face);
  CHECK(tip.feature_b.kind == Kind::vertex);
}

TEST_CASE("edges that cross from afar have their distance inside both", "[contact]") {
  const Solid below(test::tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}));
  const Solid above(test::tetrahedron({0, -1, 3}, {0, 2, 3}, {1, 0, 4}, {-1, 0, 4}));
  const Nearest n = nearest(below, above);
  CHECK(n.squared == 9);
  CHECK(n.on_a == RationalPoint{0, 0, 0});
  CHECK(n.on_b == RationalPoint{0, 0, 3});
  CHECK(n.feature_a.kind == Kind::edge);
  CHECK(n.feature_b.kind == Kind::edge);
}

TEST_CASE("among equal witnesses the lexicographically least one is told, however faces are divided", "[contact]") {
  const Nearest n = nearest(box({0, 0, 0}, {4, 4, 1}), box({1, 2, 3}, {7, 8, 9}));
  CHECK(n.squared == 4);
  CHECK(n.on_a == RationalPoint{1, 2, 1});
  CHECK(n.on_b == RationalPoint{1, 2, 3});
  const Nearest fine = nearest(Solid(test::cube_grid(4)), Solid(test::translated(test::cube_grid(4), {0.5, 0.25, 7})));
  CHECK(fine.on_a == RationalPoint{Rational(1) / 2, Rational(1) / 4, 4});
  CHECK(fine.squared == 9);
}

TEST_CASE("a gap of one ulp has its exact distance, at any scale", "[contact]") {
  for (const int exponent : {-1000, -1, 0, 500, 1020}) {
    CAPTURE(exponent);
    const double one = std::ldexp(1.0, exponent), next = std::nextafter(one, HUGE_VAL);
    const Nearest n = nearest(box({0, 0, 0}, {one, one, one}), box({next, 0, 0}, {2 * one, one, one}));
    CHECK(relation(box({0, 0, 0}, {one, one, one}), box({next, 0, 0}, {2 * one, one, one})) == Relation::apart);
    const Rational gap = to_rational(next) - to_rational(one);
    CHECK(n.squared == gap * gap);
    CHECK(n.distance == next - one);
  }
  const Nearest mixed = nearest(box({0, 0, 0}, {1e-300, 1e-300, 1e-300}), box({3e-300, 0, 0}, {1e300, 1e300, 1e300}));
  const Rational gap = to_rational(3e-300) - to_rational(1e-300);
  CHECK(mixed.squared == gap * gap);
  const Nearest far = nearest(box({-1.7e308, 0, 0}, {-1.6e308, 1, 1}), box({1.6e308, 0, 0}, {1.7e308, 1, 1}));
  CHECK(far.squared == 4 * to_rational(1.6e308) * to_rational(1.6e308));
  CHECK(std::isinf(far.distance));
}

Rational squared_distance(const RationalPoint& p, const RationalPoint& q) {
  Rational sum;
  for (std::size_t i = 0; i < 3; ++i) sum += (q[i] - p[i]) * (q[i] - p[i]);
  return sum;
}

/// Twice as large as wanted, for a half of nothing.
Mesh grown(Mesh mesh, double factor) {
  for (Vertex& v : mesh.vertices)
    for (double& x : v) x *= factor;
  return mesh;
}

// Laws, and a sample of points that must not be nearer.
TEST_CASE("distances are symmetric, belong to their witnesses and are the least", "[contact][property]") {
  std::size_t apart = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Mesh mesh_a = test::lattice_solid(random);
    const Vertex by{double(random.between(-6, 6)), double(random.between(-6, 6)), double(random.between(-6, 6))};
    const Mesh mesh_b = test::translated(test::lattice_solid(random), by);
    const Solid a(mesh_a), b(mesh_b);
    if (a.is_empty() || b.is_empty() || relation(a, b) != Relation::apart) continue;
    ++apart;
    const Nearest n = nearest(a, b), back = nearest(b, a);
    CHECK(n.squared > 0);
    CHECK(back.squared == n.squared);
    CHECK(squared_distance(n.on_a, n.on_b) == n.squared);
    CHECK(nearest(Solid(test::relisted(mesh_a)), b).on_a == n.on_a);
    CHECK(nearest(Solid(grown(mesh_a, 0x1p-400)), Solid(grown(mesh_b, 0x1p-400))).squared ==
          n.squared * to_rational(0x1p-800));
    for (const Triangle& f : mesh_a.triangles)
      for (const Triangle& g : mesh_b.triangles) {
        Vertex p{}, q{};
        double weights[6], sum_f = 0, sum_g = 0;
        for (double& w : weights) w = double(random.between(0, 8));
        for (std::size_t c = 0; c < 3; ++c) {
          sum_f += weights[c];
          sum_g += weights[c + 3];
        }
        if (sum_f == 0 || sum_g == 0) continue;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t c = 0; c < 3; ++c) {
            p[i] += weights[c] / sum_f * mesh_a.vertices[f[c]][i];
            q[i] += weights[c + 3] / sum_g * mesh_b.vertices[g[c]][i];
          }
        const double d =
            std::sqrt((q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]) + (q[2] - p[2]) * (q[2] - p[2]));
        if (d < n.distance * (1 - 1e-12)) FAIL("nearer points were found");
      }
  }
  CHECK(apart > 60);
}

}  // namespace
}  // namespace strata::contact
