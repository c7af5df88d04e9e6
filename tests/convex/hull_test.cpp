#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "strata/convex.h"
#include "strata/measure.h"
#include "support/random.h"
#include "support/rounds.h"

namespace strata::convex {
namespace {

using Points = std::vector<Vertex>;
using Whole = std::array<long, 3>;

bool are_equal(const Polytope& a, const Polytope& b) {
  const auto same = [](const ExactVertex& x, const ExactVertex& y) {
    return x.vertex == y.vertex && x.position == y.position;
  };
  return a.dimension == b.dimension && a.vertices == b.vertices && a.facets == b.facets &&
         std::equal(a.exact.begin(), a.exact.end(), b.exact.begin(), b.exact.end(), same);
}

/// No violations, every vertex is a point, and no point is outside: then it is the hull.
void require_hull(const Polytope& hull, ExactMeshView points) {
  REQUIRE(violations(hull) == std::vector<std::string>());
  std::set<RationalPoint> places;
  for (std::uint32_t p = 0; p < points.mesh.vertices.size(); ++p) places.insert(points.position(p));
  for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) REQUIRE(places.count(hull.position(v)) == 1);
  if (hull.dimension < 3) return;
  for (const auto& loop : hull.facets) {
    const RationalPoint a = hull.position(loop[0]), b = hull.position(loop[1]), c = hull.position(loop[2]);
    RationalPoint n;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    const auto height = [&](const RationalPoint& p) {
      return Rational(n[0] * (p[0] - a[0]) + n[1] * (p[1] - a[1]) + n[2] * (p[2] - a[2])).sign();
    };
    REQUIRE(std::none_of(places.begin(), places.end(), [&](const RationalPoint& p) { return height(p) > 0; }));
  }
}

ExactMeshView view(const Points& points) { return {MeshView(points, {}), {}}; }

Polytope checked_hull(const Points& points) {
  const Polytope hull = convex_hull(points);
  require_hull(hull, view(points));
  return hull;
}

Points grid(int nx, int ny, int nz, double unit = 1) {
  Points points;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) points.push_back({x * unit, y * unit, z * unit});
  return points;
}

Points random_lattice(test::Random& random, int count, int size) {
  Points points;
  for (int n = 0; n < count; ++n) {
    Vertex p;
    for (double& x : p) x = random.between(-size, size);
    points.push_back(p);
  }
  return points;
}

/// Planes that hold three points at least, not collinear, and have no point above, each as the set of its points.
std::set<std::set<Whole>> supporting_planes(const std::set<Whole>& points) {
  const std::vector<Whole> p(points.begin(), points.end());
  std::set<std::set<Whole>> planes;
  for (const Whole& a : p)
    for (const Whole& b : p)
      for (const Whole& c : p) {
        Whole n;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        }
        if (n == Whole{0, 0, 0}) continue;
        std::set<Whole> in_plane;
        bool is_supporting = true;
        for (const Whole& q : p) {
          const long height = n[0] * (q[0] - a[0]) + n[1] * (q[1] - a[1]) + n[2] * (q[2] - a[2]);
          is_supporting &= height <= 0;
          if (height == 0) in_plane.insert(q);
        }
        if (is_supporting) planes.insert(in_plane);
      }
  return planes;
}

/// A point is extreme when three supporting planes meet in it alone, so when it is on three of them.
std::set<Whole> corners(const std::set<std::set<Whole>>& planes, const std::set<Whole>& points) {
  std::set<Whole> result;
  for (const Whole& p : points)
    if (std::count_if(planes.begin(), planes.end(), [&](const auto& plane) { return plane.count(p) != 0; }) >= 3)
      result.insert(p);
  return result;
}

std::set<Whole> to_set(const Points& points) {
  std::set<Whole> result;
  for (const auto& [x, y, z] : points) result.insert({std::lround(x), std::lround(y), std::lround(z)});
  return result;
}

void compare_with_brute_force(const Polytope& hull, const Points& points) {
  const std::set<Whole> places = to_set(points);
  const auto planes = supporting_planes(places);
  if (hull.dimension < 3) {  // a plane that holds everything supports it from both sides and is one set
    REQUIRE(planes.size() == (hull.dimension == 2 ? 1 : 0));
    return;
  }
  REQUIRE(to_set(hull.vertices) == corners(planes, places));
  REQUIRE(hull.facets.size() == planes.size());
}

RationalPoint divided(const Vertex& p, int by) {
  RationalPoint r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = to_rational(p[i]) / by;
  return r;
}

ExactMesh exact_mesh(const std::vector<RationalPoint>& places) {
  ExactMesh mesh;
  for (const RationalPoint& p : places) {
    mesh.exact.push_back({static_cast<std::uint32_t>(mesh.mesh.vertices.size()), p});
    mesh.mesh.vertices.push_back({to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])});
  }
  return mesh;
}

}  // namespace

TEST_CASE("hulls of few points have every dimension from -1 to 3", "[convex]") {
  CHECK(checked_hull({}).dimension == -1);
  CHECK(checked_hull({{1, 2, 3}}).dimension == 0);
  CHECK(checked_hull({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).vertices == Points{{1, 2, 3}});
  const Polytope segment = checked_hull({{3, 3, 3}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  CHECK(segment.dimension == 1);
  CHECK(segment.vertices == Points{{1, 1, 1}, {3, 3, 3}});
  const Polytope triangle = checked_hull({{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {1, 1, 2}, {1, 0, 1}});
  CHECK(triangle.dimension == 2);
  CHECK(triangle.facets == std::vector<std::vector<std::uint32_t>>{{0, 1, 2}});
  CHECK(checked_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).facets ==
        std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

TEST_CASE("minus zero is zero", "[convex]") {
  const Polytope hull = checked_hull({{-0.0, 0.0, -0.0}, {0.0, -0.0, 0.0}});
  REQUIRE(hull.dimension == 0);
  for (const double x : hull.vertices[0]) CHECK(!std::signbit(x));
}

// Catches: coplanar triangles left apart, points inside facets or edges kept.
TEST_CASE("grids have eight corners and six facets, flat grids four corners", "[convex][degenerate]") {
  for (const double unit : {1.0, 0.1, 1e-300, 0x1p-1040, 1e300 / 16}) {
    CAPTURE(unit);
    const Polytope box = checked_hull(grid(10, 10, 10, unit));
    CHECK(box.vertices.size() == 8);
    CHECK(box.facets.size() == 6);
    CHECK(are_equal(convex_hull(grid(19, 19, 19, unit)), convex_hull(grid(2, 2, 2, 18 * unit))));
    for (const Points& flat : {grid(1, 9, 8, unit), grid(9, 1, 8, unit), grid(9, 8, 1, unit)}) {
      const Polytope rectangle = checked_hull(flat);
      CHECK(rectangle.dimension == 2);
      CHECK(rectangle.vertices.size() == 4);
    }
    CHECK(checked_hull(grid(1, 1, 9, unit)).vertices.size() == 2);
  }
}

TEST_CASE("a grid in a slanted plane is a parallelogram", "[convex][degenerate]") {
  Points points;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) points.push_back({i + 2.0 * j, 3.0 * i - j, 5.0 * i + 7.0 * j});
  const Polytope hull = checked_hull(points);
  CHECK(hull.dimension == 2);
  CHECK(hull.vertices.size() == 4);
}

TEST_CASE("known solids have their corners, facets and volumes", "[convex]") {
  const auto count = [](const Polytope& p) { return std::array{p.vertices.size(), p.facets.size()}; };
  Points octahedron, cuboctahedron;
  for (const Vertex& p : grid(3, 3, 3)) {
    const Vertex q{p[0] - 1, p[1] - 1, p[2] - 1};
    const double length = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
    if (length <= 1) octahedron.push_back(q);
    if (length <= 2) cuboctahedron.push_back(q);
  }
  CHECK(count(checked_hull(octahedron)) == std::array<std::size_t, 2>{6, 8});
  CHECK(count(checked_hull(cuboctahedron)) == std::array<std::size_t, 2>{12, 14});
  CHECK(volume(mesh_of(checked_hull(octahedron))) == Rational(4, 3));
  CHECK(volume(mesh_of(checked_hull(cuboctahedron))) == Rational(20, 3));
}

// Catches: coplanar faces taken for visible, horizons that are no cycle, extreme points lost.
TEST_CASE("hulls of small lattice points are those of brute force, in any order", "[convex][degenerate][property]") {
  test::Random random(1);
  for (std::uint64_t round = 0; round < test::rounds(4000); ++round) {
    CAPTURE(round);
    const int size = random.between(1, 3);
    Points points = random_lattice(random, random.between(1, size == 1 ? 20 : 14), size);
    const Polytope hull = checked_hull(points);
    compare_with_brute_force(hull, points);
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[static_cast<std::size_t>(random.between(0, static_cast<int>(i) - 1))]);
    points.push_back(points[0]);
    REQUIRE(are_equal(hull, convex_hull(points)));
  }
}

TEST_CASE("all orders of seven points have one hull", "[convex][degenerate]") {
  const Points points{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}};
  const Polytope hull = checked_hull(points);
  std::array<std::size_t, 7> order;
  std::iota(order.begin(), order.end(), 0);
  do {
    Points permuted;
    for (const std::size_t i : order) permuted.push_back(points[i]);
    REQUIRE(are_equal(hull, convex_hull(permuted)));
  } while (std::next_permutation(order.begin(), order.end()));
}

// Catches: filters without their bound, integers that are too narrow, overflow taken for a sign.
TEST_CASE("hulls of points of mixed magnitudes are exact", "[convex][property]") {
  test::Random random(2);
  for (std::uint64_t round = 0; round < test::rounds(400); ++round) {
    CAPTURE(round);
    const int range = std::array{3, 30, 200, 1000}[static_cast<std::size_t>(random.between(0, 3))];
    Points points;
    for (int n = random.between(4, 16); n > 0; --n) {
      Vertex p;
      for (double& x : p) x = std::ldexp(random.between(-4, 4), random.between(-range, range));
      points.push_back(p);
    }
    (void)checked_hull(points);
  }
}

// Catches: doubles taken for exact where they are not, on lattices that are nearly small.
TEST_CASE("points of nearly one plane on lattices of every width are told apart", "[convex][degenerate][property]") {
  test::Random random(7);
  for (int bits = 8; bits <= 52; ++bits) {
    CAPTURE(bits);
    const double large = std::ldexp(1, bits - 3);
    const auto any = [&] { return std::floor(large * random.unit()); };
    for (std::uint64_t round = 0; round < test::rounds(20); ++round) {
      Points points;
      const Vertex from{any(), any(), any()}, u{any(), -any(), any()}, v{-any(), any(), any()};
      for (int n = random.between(4, 12); n > 0; --n) {
        const int s = random.between(-1, 1), t = random.between(-1, 1);
        points.push_back({from[0] + s * u[0] + t * v[0], from[1] + s * u[1] + t * v[1], from[2] + s * u[2] + t * v[2]});
        points.back()[2] += random.once_in(3) ? random.between(-1, 1) : 0;
      }
      (void)checked_hull(points);
    }
  }
}

/// A step of one ulp decides whether a point of a facet is in, on or above it.
TEST_CASE("one ulp makes a corner", "[convex][degenerate]") {
  test::Random random(3);
  for (std::uint64_t round = 0; round < test::rounds(300); ++round) {
    CAPTURE(round);
    Points points;
    for (int n = random.between(5, 25); n > 0; --n) {
      const double s = random.between(0, 8) / 8.0, t = random.between(0, 8) / 8.0;
      Vertex p{0.1 + s, 0.7 + t, 0.3 + s / 3 + t / 7};
      const double to = random.between(-1, 1) * std::numeric_limits<double>::infinity();
      if (!std::isnan(to)) p[2] = std::nextafter(p[2], to);
      points.push_back(p);
    }
    (void)checked_hull(points);
  }
}

TEST_CASE("rational points have the hull of their multiples", "[convex][property]") {
  test::Random random(4);
  for (std::uint64_t round = 0; round < test::rounds(400); ++round) {
    CAPTURE(round);
    const Points points = random_lattice(random, random.between(1, 16), 2);
    std::vector<RationalPoint> places;
    for (const Vertex& p : points) places.push_back(divided(p, 3));
    const ExactMesh thirds = exact_mesh(places);
    const Polytope hull = convex_hull(thirds), whole = convex_hull(points);
    require_hull(hull, thirds);
    REQUIRE(hull.dimension == whole.dimension);
    REQUIRE(hull.facets == whole.facets);
    REQUIRE(hull.vertices.size() == whole.vertices.size());
    for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) REQUIRE(hull.position(v) == divided(whole.vertices[v], 3));
  }
}

TEST_CASE("a rational point above a facet by less than any double is a corner", "[convex][degenerate]") {
  const auto hull_with = [](const Rational& height) {
    const Rational third(1, 3);
    const std::vector<RationalPoint> places{{0, 0, third}, {1, 0, third}, {0, 1, third},         {1, 1, third},
                                            {0, 0, -1},    {1, 1, -1},    {third, third, height}};
    const ExactMesh mesh = exact_mesh(places);
    const Polytope hull = convex_hull(mesh);
    require_hull(hull, mesh);
    return hull.vertices.size();
  };
  const Rational little = Rational(1, Integer(1) << 200);
  CHECK(hull_with(Rational(1, 3)) == 6);
  CHECK(hull_with(Rational(1, 3) + little) == 7);
  CHECK(hull_with(Rational(1, 3) - little) == 6);
}

TEST_CASE("many points have one hull for any number of threads", "[convex]") {
  test::Random random(5);
  Points ball, cube;
  while (ball.size() < 20'000) {
    const Vertex p{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
    cube.push_back(p);
    const double length = std::hypot(p[0], p[1], p[2]);
    if (length > 0.1) ball.push_back({p[0] / length, p[1] / length, p[2] / length});
  }
  for (const Points& points : {ball, cube}) {
    const Polytope hull = convex_hull(points, 1);
    CHECK(are_equal(hull, convex_hull(points, 2)));
    const ExactMesh mesh = mesh_of(hull);
    const Topology t = topology(mesh);
    CHECK(t.euler == 2);
    CHECK(t.open_edges == 0);
    CHECK(hull.vertices.size() > 100);
    CHECK(are_equal(hull, convex_hull(hull.vertices)));
  }
}

// Catches: candidates that are left out, numbers of points mixed up on the way.
TEST_CASE("many points have the hull of the corners of a few at a time", "[convex][property]") {
  test::Random random(6);
  const auto coordinate = [&](int kind) {
    return kind == 0   ? random.between(-9, 9)
           : kind == 1 ? random.unit()
           : kind == 2 ? random.between(-99, 99) * 0.1
                       : std::ldexp(random.unit() - 0.5, random.between(-60, 0)) * 1e-280;
  };
  for (const int kind : {0, 1, 2, 3}) {
    CAPTURE(kind);
    std::vector<RationalPoint> places;
    Points points, corners;
    for (int n = 0; n < 6000; ++n) points.push_back({coordinate(kind), coordinate(kind), coordinate(kind)});
    for (std::size_t begin = 0; begin < points.size(); begin += 1000) {
      const Polytope part = convex_hull(std::span(points).subspan(begin, 1000));
      corners.insert(corners.end(), part.vertices.begin(), part.vertices.end());
    }
    const Polytope hull = convex_hull(points);
    REQUIRE(are_equal(hull, convex_hull(corners)));
    REQUIRE(violations(hull).empty());
    for (const Vertex& p : points) places.push_back(divided(p, 3));
    REQUIRE(convex_hull(exact_mesh(places)).facets == hull.facets);
  }
}

TEST_CASE("the hull of solids holds all of them", "[convex]") {
  const auto box = [](double at) {
    const Points points{{at, 0, 0},     {at + 1, 0, 0}, {at, 1, 0}, {at, 0, 1},
                        {at + 1, 1, 0}, {at + 1, 0, 1}, {at, 1, 1}, {at + 1, 1, 1}};
    return solid_of(convex_hull(points));
  };
  const std::vector<Solid> solids{box(0), box(5), Solid()};
  const Solid hull = solid_of(convex_hull(solids));
  CHECK(hull.volume() == 6);
  CHECK((box(0) - hull).is_empty());
  CHECK((box(5) - hull).is_empty());
  CHECK(solid_of(convex_hull(std::vector<Solid>{})).is_empty());
  const Solid cut = box(0) - solid_of(convex_hull(Points{{0.5, 0, 0}, {2, 0, 0}, {2, 3, 0}, {2, 0, 3}, {0.5, 0, 7}}));
  const std::vector<Solid> one{cut};
  CHECK(violations(convex_hull(one)).empty());
  Mesh tetrahedron = mesh_of(convex_hull(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})).mesh;
  tetrahedron.vertices.push_back({9, 9, 9});  // of no face
  const std::vector<Solid> with_unused{Solid(tetrahedron)};
  CHECK(convex_hull(with_unused).vertices.size() == 4);
}

TEST_CASE("what is no point is refused", "[convex]") {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(convex_hull(Points{{0, 0, 0}, {0, bad, 0}}), std::invalid_argument);
  ExactMesh mesh = exact_mesh({{Rational(1, 3), 0, 0}, {Rational(2, 3), 0, 0}});
  std::swap(mesh.exact[0], mesh.exact[1]);
  CHECK_THROWS_AS(convex_hull(mesh), std::invalid_argument);
  std::swap(mesh.exact[0], mesh.exact[1]);
  mesh.mesh.vertices[0][0] = 0.25;
  CHECK_THROWS_AS(convex_hull(mesh), std::invalid_argument);
}

// Catches: a checker that finds nothing.
TEST_CASE("violations finds every damage", "[convex]") {
  const Polytope good = convex_hull(grid(3, 3, 3));
  REQUIRE(violations(good).empty());
  const auto is_found = [](Polytope p, const auto& damage) {
    damage(p);
    return !violations(p).empty();
  };
  CHECK(is_found(good, [](Polytope& p) { p.dimension = 2; }));
  CHECK(is_found(good, [](Polytope& p) { p.dimension = 4; }));
  CHECK(is_found(good, [](Polytope& p) { p.facets.pop_back(); }));
  CHECK(is_found(good, [](Polytope& p) { p.facets.push_back(p.facets[0]); }));
  CHECK(is_found(good, [](Polytope& p) { std::reverse(p.facets[0].begin(), p.facets[0].end()); }));
  CHECK(is_found(good, [](Polytope& p) { std::swap(p.facets[0][1], p.facets[0][2]); }));
  CHECK(is_found(good, [](Polytope& p) { p.facets[0].pop_back(); }));
  CHECK(is_found(good, [](Polytope& p) { p.facets[0][0] = 8; }));
  CHECK(is_found(good, [](Polytope& p) { p.vertices[7][0] = std::nextafter(2, 3); }));
  CHECK(is_found(good, [](Polytope& p) { std::swap(p.vertices[0], p.vertices[1]); }));
  CHECK(is_found(good, [](Polytope& p) { p.vertices.push_back({3, 3, 3}); }));
  CHECK(is_found(good, [](Polytope& p) { p.vertices[3][1] = std::numeric_limits<double>::quiet_NaN(); }));
  CHECK(is_found(good, [](Polytope& p) { p.exact.push_back({0, {0, 0, 0}}); }));
  CHECK(is_found(good, [](Polytope& p) { p.exact.push_back({0, {Rational(1, 3), 0, 0}}); }));
  CHECK(is_found(good, [](Polytope& p) {  // a facet in two halves
    p.facets.push_back({p.facets[0][0], p.facets[0][1], p.facets[0][2]});
    p.facets[0].erase(p.facets[0].begin() + 1);
  }));
  const Polytope flat = convex_hull(grid(3, 3, 1)), segment = convex_hull(grid(1, 1, 3));
  CHECK(is_found(flat, [](Polytope& p) { p.vertices[3][2] = 1e-300; }));
  CHECK(is_found(flat, [](Polytope& p) { std::swap(p.facets[0][0], p.facets[0][1]); }));
  CHECK(is_found(flat, [](Polytope& p) { p.facets.clear(); }));
  CHECK(is_found(segment, [](Polytope& p) { p.vertices.push_back({1, 1, 1}); }));
  CHECK(is_found(segment, [](Polytope& p) { p.dimension = 0; }));
}

}  // namespace strata::convex
