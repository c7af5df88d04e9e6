#include "core/overlap/self_intersections.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "core/mesh/edge_table.h"
#include "core/mesh/prepare.h"
#include "core/mesh/zero_area.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/fans.h"
#include "core/overlap/intersect.h"
#include "core/overlap/meeting.h"
#include "support/shapes.h"
#include "support/transform.h"

using namespace strata;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

enum class Chain { unknown, closed };

std::vector<Pair> found_in(const Mesh& mesh, Chain chain) {
  const InputComplex input = complex_of(mesh);
  std::optional<EmbeddedStars> stars;
  if (chain == Chain::closed) stars.emplace(input, Monitor());
  std::vector<Pair> pairs;
  for (const SelfIntersection& s : find_self_intersections(input, stars ? &*stars : nullptr, Monitor()))
    pairs.emplace_back(s.face, s.other);
  return pairs;
}

std::vector<Pair> by_comparison(const InputComplex& input) {
  std::vector<Pair> pairs;
  PairIntersections intersections;
  for (std::uint32_t f = 0; f < input.face_count(); ++f)
    for (std::uint32_t g = f + 1; g < input.face_count(); ++g)
      if (meet_faces(input, FilteredFace(input, f), FilteredFace(input, g), intersections)) pairs.emplace_back(f, g);
  return pairs;
}

std::vector<Pair> by_comparison(const Mesh& mesh) { return by_comparison(complex_of(mesh)); }

/// Many triangles around one or two vertices, in directions that come again: of a grid, of a plane, or nearly one. Far
/// from the origin for some seeds; the last vertex, around which they lie, is a rational for others.
ExactMesh fans(std::mt19937& random) {
  ExactMesh result;
  Mesh& mesh = result.mesh;
  const auto number = [&](unsigned n) { return static_cast<double>(random() % n); };
  const std::array<double, 3> scale = {1, random() % 2 == 0 ? 1 : 0x1p-30, random() % 3 == 0 ? 0.0 : 1.0};
  const double shift = random() % 2 == 0 ? 0 : 0x1p20;
  const unsigned side = 3 + random() % 30;
  for (unsigned i = 0; i < 60; ++i)
    mesh.vertices.push_back(
        {shift + scale[0] * number(side), shift + scale[1] * number(side), shift + scale[2] * number(side)});
  const auto ring = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::uint32_t apexes = 1 + random() % 2;
  for (unsigned i = 0; i < apexes; ++i) {
    mesh.vertices.push_back({shift + scale[0] * number(side), shift + scale[1] * number(side), shift - number(2)});
    if (random() % 4 != 0) continue;
    const auto& p = mesh.vertices.back();
    result.exact.push_back({ring + i, {Rational(p[0]) + Rational(1, Integer(1) << 90), p[1], p[2]}});
  }
  for (unsigned i = 0; i < 100; ++i)
    mesh.triangles.push_back({static_cast<std::uint32_t>(ring + random() % apexes),
                              static_cast<std::uint32_t>(random() % mesh.vertices.size()),
                              static_cast<std::uint32_t>(random() % mesh.vertices.size())});
  const ZeroAreaTest has_no_area(mesh);
  std::vector<Triangle> sound;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    if (!repeats_vertex(mesh.triangles[f]) && !has_no_area(f)) sound.push_back(mesh.triangles[f]);
  mesh.triangles = sound;
  return result;
}

/// Two points above and below joined to a closed walk, which may wind around their axis several times or touch itself.
Mesh double_cone(std::mt19937& random) {
  const auto number = [&](unsigned n) { return static_cast<double>(random() % n); };
  Mesh mesh;
  const auto length = static_cast<std::uint32_t>(3 + random() % 7);
  for (std::uint32_t i = 0; i < length; ++i) mesh.vertices.push_back({number(5) - 2, number(5) - 2, number(3) - 1});
  mesh.vertices.push_back({number(3) - 1, number(3) - 1, 2 + number(2)});
  mesh.vertices.push_back({number(3) - 1, number(3) - 1, -2 - number(2)});
  for (std::uint32_t i = 0; i < length; ++i) {
    const std::uint32_t next = (i + 1) % length;
    mesh.triangles.push_back({i, next, length});
    mesh.triangles.push_back({next, i, length + 1});
  }
  return mesh;
}

/// Tetrahedra over few points.
Mesh tetrahedra(std::mt19937& random) {
  Mesh mesh;
  const unsigned side = 2 + random() % 3;
  for (unsigned i = 0; i < 12; ++i)
    mesh.vertices.push_back({static_cast<double>(random() % side), static_cast<double>(random() % side),
                             static_cast<double>(random() % side)});
  std::sort(mesh.vertices.begin(), mesh.vertices.end());
  mesh.vertices.erase(std::unique(mesh.vertices.begin(), mesh.vertices.end()), mesh.vertices.end());
  const auto any = [&] { return static_cast<std::uint32_t>(random() % mesh.vertices.size()); };
  for (unsigned i = 0; i < 1 + random() % 4; ++i) {
    const std::uint32_t a = any(), b = any(), c = any(), d = any();
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}});
  }
  return mesh;
}

}  // namespace

// Seen to fail: rays met twice counted as met once; the sides of one face left out; pairs with a common vertex skipped.
TEST_CASE("the pairs of faces that intersect are those found by comparing all", "[overlap][property]") {
  const unsigned seed = GENERATE(range(0u, 600u));
  std::mt19937 random(seed);
  Mesh mesh = seed % 2 == 0 ? double_cone(random) : tetrahedra(random);
  if (screen(mesh).degenerate) return;
  REQUIRE(chain_is_closed(mesh));
  const std::vector<Pair> expected = by_comparison(mesh);
  CHECK(found_in(mesh, Chain::closed) == expected);
  CHECK(found_in(mesh, Chain::unknown) == expected);
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(random() % mesh.triangles.size()));
  CHECK(found_in(mesh, Chain::unknown) == by_comparison(mesh));
}

// Seen to fail: arcs without the bulge between their ends; pairs of two fans told twice.
TEST_CASE("around vertices of many faces, the pairs that intersect are those found by comparing all",
          "[overlap][property]") {
  const unsigned seed = GENERATE(range(0u, 300u));
  std::mt19937 random(seed);
  const ExactMesh mesh = fans(random);
  if (mesh.mesh.triangles.size() < 2 * Fans::least_faces) return;
  InputComplex input(SelfIntersections::possible);
  input.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
  std::vector<Pair> pairs;
  for (const SelfIntersection& s : find_self_intersections(input, nullptr, Monitor()))
    pairs.emplace_back(s.face, s.other);
  CHECK(pairs == by_comparison(input));
}

// Seen to fail: directions without their errors.
TEST_CASE("faces of a fan that touch along a ray, without a common vertex on it, are found", "[overlap]") {
  std::mt19937 random(1);
  for (const int far : {0, 1, 1 << 20}) {
    const RationalPoint tip{far + Rational(1, 3), far + Rational(1, 7), far - Rational(1, 5)};
    std::vector<RationalPoint> points{tip};
    std::vector<Triangle> triangles;
    const auto add_point = [&](int i) {
      const auto times = static_cast<int>(1 + random() % 6);
      const Rational small(times, Integer(1) << 45);  // arcs shorter than the errors of their ends, far from the origin
      points.push_back({tip[0] + times * 41, tip[1] + small * i, tip[2] + small * i * i});
      return static_cast<std::uint32_t>(points.size() - 1);
    };
    for (int i = 0; i < 40; ++i) {
      const std::uint32_t a = add_point(i), b = add_point(i + 1);
      triangles.push_back({0, a, b});
    }
    const ExactMesh mesh = test::exact_mesh(points, triangles);
    InputComplex input(SelfIntersections::possible);
    input.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
    std::vector<Pair> found, expected;
    for (const SelfIntersection& s : find_self_intersections(input, nullptr, Monitor()))
      found.emplace_back(s.face, s.other);
    for (std::uint32_t f = 0; f + 1 < triangles.size(); ++f) expected.emplace_back(f, f + 1);
    CHECK(found == expected);
  }
}

// Seen to fail: groups that are said to be apart when they touch.
TEST_CASE("long triangles, whose boxes overlap, intersect as found by comparing all", "[overlap][property]") {
  const unsigned seed = GENERATE(range(0u, 12u));
  std::mt19937 random(seed);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  // Spokes of two wheels, the second one tilted so that it meets some of the first, in one plane, or apart.
  const double tilt = std::array<double, 3>{0.02, 0, 0}[seed % 3], lift = std::array<double, 3>{0, 0, 0.01}[seed % 3];
  constexpr std::uint32_t count = 300;
  Mesh mesh;
  for (std::uint32_t wheel = 0; wheel < 2; ++wheel) {
    const auto hub = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({0, 0, wheel * lift});
    for (std::uint32_t i = 0; i < count; ++i) {
      const double t = 2 * 3.14159265358979 * (i + wheel * 0.5) / count, z = wheel * (lift + tilt * std::cos(t));
      mesh.vertices.push_back({std::cos(t), std::sin(t), z});
      mesh.triangles.push_back({hub, hub + 1 + i, hub + 1 + (i + 1) % count});
    }
  }
  for (int i = 0; i < 10; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back({number(), number(), number()});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  CHECK(found_in(mesh, Chain::unknown) == by_comparison(mesh));
}

TEST_CASE("a fan whose faces lie apart has few pairs to compare", "[overlap]") {
  // A double cone, whose tip has two fans, once around each axis and once along a diagonal.
  constexpr std::uint32_t count = 4000;
  for (unsigned turn = 0; turn < 4; ++turn) {
    Mesh mesh;
    mesh.vertices.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i < count; ++i) {
      const double t = 2 * 3.14159265358979 * i / count;
      Vertex p{std::cos(t), std::sin(t), 1.5};
      if (turn == 3) p = {p[0] + 1, p[1] - 1, p[0] - p[1] + 1};
      std::rotate(p.begin(), p.begin() + turn % 3, p.end());
      mesh.vertices.push_back(p);
    }
    for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
    const InputComplex input = complex_of(mesh);
    const Fans fans(input, nullptr);
    std::vector<PackedBoxes::Pair> pairs;
    for (std::size_t part = 0; part < fans.part_count(); ++part) fans.append_pairs_of(part, pairs);
    CHECK(pairs.size() >= count);
    CHECK(pairs.size() < 10 * count);
  }
}

TEST_CASE("stars of a sphere are embedded, of a cube's corners not proven to be, wound twice not", "[overlap]") {
  const Mesh sphere = test::icosphere({0, 0, 0}, 1, 4);
  const EmbeddedStars stars(complex_of(sphere), Monitor());
  for (std::uint32_t v = 0; v < sphere.vertices.size(); ++v) CHECK(stars.at(v));

  const Mesh cube = test::box({0, 0, 0}, {1, 1, 1});
  const EmbeddedStars corners(complex_of(cube), Monitor());
  for (std::uint32_t v = 0; v < cube.vertices.size(); ++v) CHECK_FALSE(corners.at(v));
  CHECK(found_in(cube, Chain::closed).empty());

  const Mesh fine = test::cube_grid(3);
  const EmbeddedStars sides(complex_of(fine), Monitor());
  for (std::uint32_t v = 0; v < fine.vertices.size(); ++v) {
    const Vertex& p = fine.vertices[v];
    const auto is_at_end = [](double x) { return x == 0 || x == 3; };
    CHECK(sides.at(v) == !(is_at_end(p[0]) && is_at_end(p[1]) && is_at_end(p[2])));
  }

  Mesh wound{{{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {3, 0, 0}, {-1, 3, 0}, {-1, -3, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    wound.triangles.push_back({i, (i + 1) % 6, 6});
    wound.triangles.push_back({(i + 1) % 6, i, 7});
  }
  const EmbeddedStars twice(complex_of(wound), Monitor());
  CHECK_FALSE(twice.at(6));
  CHECK_FALSE(twice.at(7));
  CHECK(found_in(wound, Chain::closed) == by_comparison(wound));
  CHECK_FALSE(found_in(wound, Chain::closed).empty());
}

TEST_CASE("intersections of many faces: one list for any number of threads, some of them when asked for few",
          "[overlap]") {
  Mesh mesh = test::icosphere({0, 0, 0}, 1, 5);
  const Mesh other = test::icosphere({0.01, 0.02, 0.03}, 1, 5);
  const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const InputComplex input = complex_of(mesh);
  const EmbeddedStars stars(input, Monitor());
  const auto find = [&](int threads, std::size_t enough) {
    return tbb::task_arena(threads).execute([&] { return find_self_intersections(input, &stars, Monitor(), enough); });
  };
  const auto pairs = [](const std::vector<SelfIntersection>& found) {
    std::vector<Pair> list;
    for (const SelfIntersection& s : found) list.emplace_back(s.face, s.other);
    return list;
  };
  const auto all = pairs(find(1, SIZE_MAX));
  CHECK(all.size() > 500);
  CHECK(pairs(find(2, SIZE_MAX)) == all);
  CHECK(pairs(find(4, SIZE_MAX)) == all);
  const auto few = pairs(find(1, 3));
  CHECK(few.size() >= 3);
  CHECK(few.size() <= all.size());
  CHECK(pairs(find(4, 3)) == few);
  CHECK(std::includes(all.begin(), all.end(), few.begin(), few.end()));

  // A search that has stopped goes on, and tells how faces meet as the Boolean finds it pair by pair.
  SelfIntersectionSearch search(input, &stars);
  CHECK(pairs(search.find({}, 1)).size() < all.size());
  std::vector<PairIntersections> met;
  CHECK(pairs(search.find({}, SelfIntersectionSearch::all, &met)) == all);
  const Intersections from_search = intersect(input, met, {});
  const Intersections one_by_one = intersect(input, find(1, SIZE_MAX), {});
  CHECK(from_search.pairs_meeting == all.size());
  CHECK(from_search.constraints.size() == one_by_one.constraints.size());
  CHECK(from_search.points.end() == one_by_one.points.end());
}

TEST_CASE("vertices that are no doubles decide as they are", "[overlap]") {
  // A roof whose ridge passes a third above or below the tip of a spike, which rounding moves to the same double.
  for (const int sign : {-1, 1}) {
    ExactMesh mesh;
    mesh.mesh = test::box({0, 0, 0}, {3, 3, 1});
    const Mesh spike = test::tetrahedron({1, 1, 3}, {2, 1, 3}, {1, 2, 3}, {1, 1, 1});
    const auto shift = static_cast<std::uint32_t>(mesh.mesh.vertices.size());
    mesh.mesh.vertices.insert(mesh.mesh.vertices.end(), spike.vertices.begin(), spike.vertices.end());
    for (const Triangle& t : spike.triangles) mesh.mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    const Rational tip = Rational(1) + Rational(sign, Integer(1) << 80);
    for (std::uint32_t v = shift; v < mesh.mesh.vertices.size(); ++v)
      if (mesh.mesh.vertices[v] == Vertex{1, 1, 1}) mesh.exact.push_back({v, {1, 1, tip}});
    REQUIRE(mesh.exact.size() == 1);
    InputComplex input(SelfIntersections::possible);
    input.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
    const EmbeddedStars stars(input, Monitor());
    CHECK(find_self_intersections(input, &stars, Monitor()).empty() == (sign > 0));
  }
}
