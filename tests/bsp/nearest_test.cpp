#include <catch2/catch.hpp>
#include <cmath>

#include "extensions/bsp/partition_data.h"
#include "support/random.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::bsp {
namespace {

using test::Random;

Rational dot(const RationalPoint& u, const RationalPoint& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

/// Squared, by barycentric coordinates; another way than the library's.
Rational distance_to_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  Rational t = dot(p - a, b - a) / dot(b - a, b - a);
  t = std::max(Rational(0), std::min(Rational(1), t));
  const RationalPoint q{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  return dot(p - q, p - q);
}

Rational distance_to_triangle(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b,
                              const RationalPoint& c) {
  const RationalPoint u = b - a, v = c - a, w = p - a;
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Rational whole = uu * vv - uv * uv, s = (wu * vv - wv * uv) / whole, t = (wv * uu - wu * uv) / whole;
  if (s >= 0 && t >= 0 && s + t <= 1) {
    const RationalPoint q{a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1], a[2] + s * u[2] + t * v[2]};
    return dot(p - q, p - q);
  }
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

}  // namespace

TEST_CASE("nearest points of solids are those that asking every triangle finds", "[bsp][property]") {
  for (std::uint64_t seed = 0; seed < test::rounds(150); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Mesh mesh = test::lattice_solid(random);
    const Partition<3> region = partition_of(ExactMesh{mesh, {}});
    for (int k = 0; k < 10; ++k) {
      RationalPoint p;
      for (Rational& x : p)
        x = random.once_in(2) ? Rational(random.between(-4, 16), 3) : Rational(random.between(-1, 5));
      Rational least = -1;
      for (const Triangle& t : mesh.triangles) {
        std::array<RationalPoint, 3> q;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis) q[i][axis] = to_rational(mesh.vertices[t[i]][axis]);
        const Rational d = distance_to_triangle(p, q[0], q[1], q[2]);
        if (least < 0 || d < least) least = d;
      }
      const auto nearest = nearest_boundary_point<3>(region, p);
      REQUIRE(nearest.has_value());
      CHECK(nearest->squared_distance == least);
      CHECK(region.classify_exact(nearest->point) == Where::on);
      const Where where = region.classify_exact(p);
      CHECK((nearest->distance < 0) == (where == Where::in));
      CHECK((nearest->distance == 0) == (where == Where::on));
      const auto of_rest = nearest_boundary_point<3>(complement(region), p);
      CHECK(of_rest->squared_distance == least);
    }
  }
}

TEST_CASE("nearest points of what has no end", "[bsp]") {
  const auto behind = [](std::size_t axis, int value) {
    AffineForm<3> form{0, 0, 0, -value};
    form[axis] = 1;
    return Partition<3>::half_space(form);
  };
  const Partition<3> half = behind(2, 0), wedge = half & behind(0, 0), outer = complement(wedge),
                     slab = half - behind(2, -2);
  const auto at = [](const Partition<3>& r, int x, int y, int z) {
    return *nearest_boundary_point<3>(r, RationalVector<3>{x, y, z});
  };
  CHECK(at(half, 5, 6, 7).point == RationalVector<3>{5, 6, 0});
  CHECK(at(half, 5, 6, 7).distance == 7);
  CHECK(at(half, 5, 6, -7).distance == -7);
  CHECK(at(wedge, 3, 6, 4).point == RationalVector<3>{0, 6, 0});  // the edge
  CHECK(at(wedge, 3, 6, 4).distance == 5);
  CHECK(at(outer, 3, 6, 4).distance == -5);
  CHECK(at(wedge, -1, 6, -3).point == RationalVector<3>{0, 6, -3});
  CHECK(at(wedge, -3, 0, 9).point == RationalVector<3>{-3, 0, 0});
  CHECK(at(slab, 0, 0, -3).point == RationalVector<3>{0, 0, -2});
  CHECK_FALSE(nearest_boundary_point<3>(Partition<3>::all(), RationalVector<3>{}).has_value());
}

TEST_CASE("nearest points on the line and in the plane", "[bsp]") {
  const Partition<1> two = partition_of(std::vector<Interval>{{Rational(0), Rational(1)}, {Rational(4), std::nullopt}});
  CHECK(nearest_boundary_point<1>(two, {Rational(2)})->point == RationalVector<1>{1});
  CHECK(nearest_boundary_point<1>(two, {Rational(9)})->distance == -5);
  const std::vector<PolygonLoop> ring{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  const Partition<2> r = partition_of(ring);
  CHECK(nearest_boundary_point<2>(r, {Rational(4), Rational(9, 2)})->point == RationalVector<2>{3, Rational(9, 2)});
  CHECK(nearest_boundary_point<2>(r, {Rational(2), Rational(4)})->distance == -1);
  CHECK(nearest_boundary_point<2>(r, {Rational(12), Rational(13)})->point == RationalVector<2>{9, 9});
  CHECK(nearest_boundary_point<2>(r, {Rational(12), Rational(13)})->distance == 5);
  const auto half = behind(line_through({0, 0}, {1, 1}));
  CHECK(nearest_boundary_point<2>(half, {Rational(0), Rational(2)})->point == RationalVector<2>{1, 1});
}

TEST_CASE("square roots of fractions are rounded correctly", "[bsp][property]") {
  CHECK(nearest_square_root(0) == 0);
  CHECK(nearest_square_root(Rational(9, 4)) == 1.5);
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const double x = std::ldexp(1 + random.unit(), random.between(-500, 500));
    CAPTURE(seed, x);
    const Rational exact = to_rational(x);
    CHECK(nearest_square_root(exact * exact) == x);
    CHECK(nearest_square_root(exact) == std::sqrt(x));  // IEEE: correctly rounded
    // Around the middle of two doubles.
    const Rational middle = (exact + to_rational(std::nextafter(x, HUGE_VAL))) / 2;
    const Rational little = exact * exact / (Integer(1) << 200);
    CHECK(nearest_square_root(middle * middle - little) == x);
    CHECK(nearest_square_root(middle * middle + little) == std::nextafter(x, HUGE_VAL));
  }
}

}  // namespace strata::bsp
