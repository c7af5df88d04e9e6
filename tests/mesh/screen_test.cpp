#include <catch2/catch.hpp>
#include <chrono>
#include <limits>
#include <random>

#include "core/mesh/prepare.h"
#include "shapes.h"
#include "strata/measure.h"

using namespace strata;
using namespace strata::shapes;

TEST_CASE("a good mesh passes the screen at any scale and place", "[mesh]") {
  for (const double scale : {1.0, 1e-200, 1e150, 5e-324, 1e300, 0x1p-1022}) {
    const Screening facts = screen(scaled(box({0, 0, 0}, {1, 2, 3}), scale));
    CHECK(facts.finite);
    CHECK(facts.indices_valid);
    CHECK(facts.chain_closed);
    CHECK_FALSE(facts.degenerate);
    CHECK(facts.orientation == 1);
    CHECK(screen(flipped(scaled(box({0, 0, 0}, {1, 2, 3}), scale))).orientation == -1);
  }
  const Screening far = screen(moved(scaled(globe(20), 0x1p-30), {1e6, -1e6, 1e6}));
  CHECK(far.orientation == 1);
}

TEST_CASE("an empty mesh is closed", "[mesh]") {
  const Screening facts = screen(Mesh{});
  CHECK(facts.chain_closed);
  CHECK(facts.orientation == 0);
}

TEST_CASE("the screen sees coordinates that are not finite only where they are used", "[mesh]") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.vertices.push_back({0, bad, 0});
    CHECK(screen(mesh).finite);
    CHECK(screen(mesh).orientation == 1);
    mesh.vertices[3][2] = bad;
    CHECK_FALSE(screen(mesh).finite);
  }
}

// Catches: corners left out, a run of triangles left out, vertices counted that no triangle has.
TEST_CASE("the screen finds the box of the vertices in use", "[mesh]") {
  Mesh one = box({1, 2, 3}, {4, 5, 6});
  one.vertices.push_back({-9, 99, 9});
  CHECK(screen(one).bounds.lower == Vertex{1, 2, 3});
  CHECK(screen(one).bounds.upper == Vertex{4, 5, 6});
  for (std::size_t k = 0; k < 3; ++k)
    for (const double far : {-7.0, 7.0}) {
      Mesh many = globe(80);  // several runs
      Vertex& v = many.vertices[many.triangles[many.triangles.size() * k / 2 - (k == 2 ? 1 : 0)][k]];
      v[k] = far;
      const Screening facts = screen(many);
      CHECK((far < 0 ? facts.bounds.lower : facts.bounds.upper)[k] == far);
    }
}

TEST_CASE("the screen sees indices out of range", "[mesh]") {
  Mesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles[5][1] = 8;
  CHECK_FALSE(screen(mesh).indices_valid);
}

TEST_CASE("the screen sees every missing, reversed or doubled triangle", "[mesh]") {
  const Mesh mesh = globe(12);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Mesh missing = mesh, turned = mesh, doubled = mesh;
    missing.triangles.erase(missing.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    std::swap(turned.triangles[i][0], turned.triangles[i][1]);
    doubled.triangles.push_back(mesh.triangles[i]);
    CHECK_FALSE(screen(missing).chain_closed);
    CHECK_FALSE(screen(turned).chain_closed);
    CHECK_FALSE(screen(doubled).chain_closed);
  }
}

TEST_CASE("triangles of zero area are found exactly, near ones are not taken for them", "[mesh]") {
  const auto with_triangle = [](const Vertex& a, const Vertex& b, const Vertex& c) {
    return screen(Mesh{{a, b, c}, {{0, 1, 2}, {0, 2, 1}}}).degenerate;
  };
  CHECK(with_triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  CHECK(with_triangle({0, 0, 0}, {1, 1, 1}, {1, 1, 1}));
  CHECK(with_triangle({1e-300, 0, 0}, {2e-300, 0, 0}, {1e300, 0, 0}));
  CHECK_FALSE(with_triangle({0, 0, 0}, {1, 1, 1}, {2, 2, std::nextafter(2.0, 3.0)}));
  CHECK_FALSE(with_triangle({0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}));
  CHECK_FALSE(with_triangle({0, 0, 0}, {1e308, 0, 0}, {-1e308, 1e-308, 0}));
  CHECK_FALSE(with_triangle({0, 0, 0}, {0.1, 0.3, 0}, {1, 3, 0}));  // 0.3 is not 3 * 0.1 in doubles
  CHECK(screen(Mesh{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}).degenerate);
}

TEST_CASE("the sign of a volume is exact when it is lost in rounding", "[mesh]") {
  const Mesh cube = box({-1, -1, -1}, {1, 1, 1});
  Mesh larger = box({-1, -1, -1}, {1, 1, 1 + 0x1p-52});
  CHECK(screen(joined(cube, flipped(cube))).orientation == 0);
  CHECK(screen(joined(larger, flipped(cube))).orientation == 1);
  CHECK(screen(joined(cube, flipped(larger))).orientation == -1);
  CHECK(screen(joined(box({0, 0, 0}, {1e-150, 1e-150, 1e-150}), joined(cube, flipped(cube)))).orientation == 1);
}

TEST_CASE("the screen of random closed surfaces agrees with the exact volume", "[mesh][property]") {
  const auto seed = GENERATE(take(100, random(0, 1'000'000)));
  CAPTURE(seed);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_int_distribution<int> small(-2, 2);
  Mesh mesh;
  for (int i = 0; i < 6; ++i) mesh.vertices.push_back({small(random) + 0.0, small(random) + 0.0, small(random) + 0.0});
  for (int i = 0; i < 4; ++i) {  // boundaries of tetrahedra over any four of the vertices
    const auto v = [&] { return static_cast<std::uint32_t>(random() % 6); };
    const std::uint32_t a = v(), b = v(), c = v(), d = v();
    for (const Triangle& t : {Triangle{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}}) mesh.triangles.push_back(t);
  }
  const Screening facts = screen(mesh);
  CHECK(facts.chain_closed);
  CHECK(facts.orientation == volume({mesh, {}}).sign());
  bool flat = false;
  for (const Triangle& t : mesh.triangles) flat = flat || area({Mesh{mesh.vertices, {t}}, {}}) == 0;
  CHECK(facts.degenerate == flat);
}

TEST_CASE("screening a million triangles takes milliseconds", "[mesh][slow]") {
  const Mesh mesh = globe(800);
  double best = 1;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Screening facts = screen(mesh);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    CHECK(facts.orientation == 1);
  }
  WARN(mesh.triangles.size() << " triangles: " << best * 1000 << " ms");
}
