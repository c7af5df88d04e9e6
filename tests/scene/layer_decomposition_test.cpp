#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "extensions/scene/subordination.h"
#include "scene/rational_rays.h"
#include "scene/scenes.h"
#include "strata/query.h"

using namespace strata;

namespace {

RationalPoint rational_origin(const Origin& origin) { return test::rational(origin.at); }

/// A point inside a triangle, with weights that are no nice numbers.
RationalPoint inner_point(const test::RationalTriangle& t, test::Random& random) {
  const Rational a = random.between(1, 999), b = random.between(1, 999), c = random.between(1, 999);
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = (a * t[0][i] + b * t[1][i] + c * t[2][i]) / (a + b + c);
  return p;
}

/// Checks along the rays through inner points of pieces that what comes first is in a higher layer.
void check_order(const LayerDecomposition& d, test::Random& random, int rays) {
  std::vector<std::uint32_t> live;
  std::vector<test::RationalTriangle> triangles;
  for (std::uint32_t p = 0; p < d.piece_count(); ++p) {
    if (d.is_replaced(p)) continue;
    live.push_back(p);
    triangles.push_back(d.triangle(p));
  }
  for (int n = 0; n < rays; ++n) {
    const auto from = static_cast<std::size_t>(random.below(live.size()));
    if (d.layer(live[from]) == 0) continue;
    const RationalPoint through = inner_point(triangles[from], random);
    const bool far = !d.origin().is_point();
    const test::RationalVector direction =
        far ? rational_origin(d.origin()) : test::minus(through, rational_origin(d.origin()));
    const RationalPoint base = far ? through : rational_origin(d.origin());
    std::vector<std::pair<Rational, std::uint32_t>> hits;
    bool general = true;
    for (std::size_t i = 0; i < live.size(); ++i) {
      test::RationalHit hit;
      const auto m = test::meet(triangles[i], base, direction, hit);
      if (d.layer(live[i]) == 0) continue;  // flat: seen from the side
      general = general && m != test::RayMeets::rim_or_plane;
      if (m == test::RayMeets::inside && (far || hit.t > 0)) hits.emplace_back(hit.t, live[i]);
    }
    if (!general) continue;
    std::sort(hits.begin(), hits.end());
    for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
      if (hits[i].first == hits[i + 1].first) continue;
      CAPTURE(hits[i].second, hits[i + 1].second);
      REQUIRE(d.layer(hits[i].second) > d.layer(hits[i + 1].second));
    }
  }
}

/// A flat tetrahedron under a triangle.
Mesh thin_triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vertex tip{a[0] / 4 + b[0] / 4 + c[0] / 2, a[1] / 4 + b[1] / 4 + c[1] / 2,
                   a[2] / 4 + b[2] / 4 + c[2] / 2 - 0.015625};
  return test::tetrahedron(a, b, c, tip);
}

/// n triangles around the z axis, each with one end above the next.
std::vector<Mesh> ring_of(int n) {
  std::vector<Mesh> meshes;
  for (int i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * (i + 1.6) / n;
    const auto coarse = [](double x) { return std::round(x * 1024) / 1024; };
    const Vertex p{coarse(3 * std::cos(a)), coarse(3 * std::sin(a)), 0},
        q{coarse(4 * std::cos(a)), coarse(4 * std::sin(a)), 0},
        r{coarse(3.5 * std::cos(b)), coarse(3.5 * std::sin(b)), 1};
    meshes.push_back(thin_triangle(p, q, r));
  }
  return meshes;
}

}  // namespace

TEST_CASE("layers order every ray, from any origin, in scenes that touch, cross and overlap", "[layers][property]") {
  const auto seed = GENERATE(range(0, 90));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed) + 5);
  const auto meshes = test::touching_operands(static_cast<std::uint64_t>(seed)).meshes;
  const Origin origin = test::awkward_origin(meshes, random);
  CAPTURE(origin.is_point(), origin.at[0], origin.at[1], origin.at[2]);
  const LayerDecomposition d(test::scene_of(meshes), origin);
  REQUIRE(d.validate().empty());
  check_order(d, random, 40);
}

TEST_CASE("signs alternate along rays of one solid", "[layers]") {
  const Mesh box = test::box_with_cavity(2);
  const LayerDecomposition d(test::scene_of({box}), Origin::point({2.1, 1.95, 2.03}));
  CHECK(d.layer_count() == 2);
  CHECK(d.cuts_of_cycles() == 0);
  for (std::uint32_t f = 0; f < d.piece_count(); ++f) {
    CHECK(d.sign(f) == (d.layer(f) == 1 ? 1 : -1));
  }
}

TEST_CASE("a convex solid seen from inside has one layer", "[layers]") {
  const LayerDecomposition d(test::scene_of({test::icosphere({0, 0, 0}, 1, 3)}), Origin::point({.1, .2, .3}));
  CHECK(d.layer_count() == 1);
  CHECK(d.domination_count() == 0);
}

TEST_CASE("interlocked bars are cut open", "[layers][degenerate]") {
  const std::vector<Mesh> bars{test::box({-4, 0, 2}, {6, 1, 3}), test::box({2, -4, 0}, {3, 6, 1}),
                               test::box({0, 2, -4}, {1, 3, 6})};
  const LayerDecomposition d(test::scene_of(bars), Origin::point({90, 90.25, 90.5}));
  CHECK(d.cuts_of_cycles() >= 1);
  CHECK(d.validate().empty());
  test::Random random(1);
  check_order(d, random, 300);
}

TEST_CASE("rings of triangles that overlap one another are cut open, once each", "[layers][degenerate]") {
  const int n = GENERATE(3, 4, 5, 13, 50);
  CAPTURE(n);
  const auto meshes = ring_of(n);
  test::Random random(static_cast<std::uint64_t>(n));
  for (const Origin& origin : {Origin::direction({0, 0, -1}), Origin::point({.01, .02, 40})}) {
    const LayerDecomposition d(test::scene_of(meshes), origin);
    CHECK(d.cuts_at_crossings() == 0);
    CHECK(d.cuts_of_cycles() >= 1);
    CHECK(d.cuts_of_cycles() <= 12);
    CHECK(d.validate().empty());
    check_order(d, random, 100);
  }
}

TEST_CASE("a random heap of needles is put in order", "[layers][property]") {
  const auto seed = GENERATE(range(0, 4));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed));
  std::vector<Mesh> meshes;
  for (int i = 0; i < 40; ++i) {
    Vertex a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = random.between(0, 256) / 64.0;
      b[k] = random.between(0, 256) / 64.0;
    }
    const Vertex c{a[0] + random.between(1, 20) / 64.0, a[1] + random.between(1, 20) / 64.0, a[2]};
    meshes.push_back(thin_triangle(a, b, c));
  }
  for (Mesh& m : meshes)
    if (m.triangles.empty()) m = test::box({9, 9, 9}, {10, 10, 10});
  const LayerDecomposition d(test::scene_of(meshes),
                             seed % 2 == 0 ? Origin::direction({.125, .25, -1}) : Origin::point({2, 2, 9}));
  CHECK(d.validate().empty());
  check_order(d, random, 60);
}

TEST_CASE("the named overlaps of tetrahedra", "[layers][degenerate]") {
  // From the origin along +z; triangle s is at z = 1.
  const std::vector<Vertex> vertices{{0, 0, 1},  {4, 0, 1},  {0, 4, 1},   // s
                                     {1, 1, 2},  {2, 1, 2},  {1, 2, 2},   // beyond it
                                     {9, 0, 1},  {12, 0, 1}, {9, 3, 1},   // beside it
                                     {4, 0, 1},  {0, 4, 1},  {4, 4, 1},   // along its rim
                                     {1, 1, .5}, {2, 1, 2},  {1, 2, 2},   // through it
                                     {1, 1, 1},  {2, 1, 1},  {1, 2, 1}};  // in it
  std::vector<InputComplex::Indices> faces;
  for (std::uint32_t i = 0; i < vertices.size(); i += 3) faces.push_back({i, i + 1, i + 2});
  InputComplex input;
  input.add(vertices, faces);
  for (const Origin& origin : {Origin::direction({0, 0, 1}), Origin::point({0.5, 0.25, -100})}) {
    const Sight sight(input, origin);
    const auto seen = [&](std::uint32_t f) { return SeenTriangle{input.face(f), sight.orientation(input.face(f))}; };
    const auto check = [&](std::uint32_t f, TetrahedraOverlap there, TetrahedraOverlap back) {
      CAPTURE(f);
      CHECK(overlap_of(sight, seen(0), seen(f)) == there);
      CHECK(overlap_of(sight, seen(f), seen(0)) == back);
    };
    check(1, TetrahedraOverlap::before, TetrahedraOverlap::behind);
    check(2, TetrahedraOverlap::apart, TetrahedraOverlap::apart);
    check(3, TetrahedraOverlap::touching, TetrahedraOverlap::touching);
    check(4, TetrahedraOverlap::crossing, TetrahedraOverlap::crossing);
    check(5, TetrahedraOverlap::coplanar, TetrahedraOverlap::coplanar);
  }
}
