#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <random>

#include "shapes.h"
#include "strata/measure.h"

using namespace strata;
using namespace strata::shapes;

namespace {

CanonicalForm form(const Mesh& mesh) { return canonical_form(ExactMesh{mesh, {}}); }

/// Every face of a box in n x n cells of two triangles, or with every other cell in four, which makes T-junctions
/// when `crooked`.
Mesh gridded_box(const Vertex& lower, const Vertex& upper, int n, bool crooked = false) {
  const Mesh coarse = box(lower, upper);
  Mesh mesh;
  const auto emit = [&](const Vertex& a, const Vertex& b, const Vertex& c) {
    const auto i = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({i, i + 1, i + 2});
  };
  for (std::size_t face = 0; face < 6; ++face) {
    const Triangle& t = coarse.triangles[2 * face];  // two sides of the face meet at its second vertex
    const Vertex& a = coarse.vertices[t[0]];
    const Vertex& b = coarse.vertices[t[1]];
    const Vertex& c = coarse.vertices[t[2]];
    const auto at = [&](double u, double v) {
      Vertex p;
      for (int k = 0; k < 3; ++k) p[k] = a[k] + (b[k] - a[k]) * (u / n) + (c[k] - b[k]) * (v / n);
      return p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const Vertex p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
        if (crooked && (i + j) % 2 == 0) {
          const Vertex m = at(i + 0.5, j), o = at(i + 1, j + 0.5);
          emit(p, m, s), emit(m, o, s), emit(m, q, o), emit(o, r, s);
        } else {
          emit(p, q, r), emit(p, r, s);
        }
      }
    }
  }
  return mesh;
}

/// The cube [0,4]^3 with a square hole [1,3]^2 through along z, by rings of quadrangles.
Mesh pierced_cube() {
  Mesh mesh;
  for (const double z : {0.0, 4.0}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}}) {
      mesh.vertices.push_back({double(x), double(y), z});
    }
  }
  const auto quadrangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    quadrangle(i, j, j + 8, i + 8);            // outer wall
    quadrangle(4 + j, 4 + i, 12 + i, 12 + j);  // inner wall
    quadrangle(8 + i, 8 + j, 12 + j, 12 + i);  // top
    quadrangle(j, i, 4 + i, 4 + j);            // bottom
  }
  return mesh;
}

RationalPoint point(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

/// A prism over a counter-clockwise polygon, as facets with the polygon on top and bottom.
std::vector<ExactFacet> prism(const std::vector<std::pair<Rational, Rational>>& loop, const Rational& bottom,
                              const Rational& top) {
  std::vector<ExactFacet> facets(2);
  facets[0].resize(1);
  facets[1].resize(1);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& [x, y] = loop[i];
    const auto& [u, v] = loop[(i + 1) % loop.size()];
    facets[0][0].push_back(point(x, y, top));
    facets[1][0].insert(facets[1][0].begin(), point(x, y, bottom));
    facets.push_back({{point(x, y, bottom), point(u, v, bottom), point(u, v, top), point(x, y, top)}});
  }
  return facets;
}

template <class T>
std::vector<T> concatenated(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("a box has six facets, twelve edges and eight vertices however it is triangulated", "[mesh]") {
  const CanonicalForm expected = form(box({0, 0, 0}, {5, 5, 5}));
  CHECK(expected.vertices.size() == 8);
  CHECK(expected.facet_count() == 6);
  CHECK(expected.edge_count() == 12);
  CHECK(form(gridded_box({0, 0, 0}, {5, 5, 5}, 5)) == expected);
  CHECK(form(gridded_box({0, 0, 0}, {5, 5, 5}, 5, true)) == expected);
  CHECK(form(shattered(box({0, 0, 0}, {5, 5, 5}))).hash() == expected.hash());
  CHECK_FALSE(form(box({0, 0, 0}, {5, 5, 6})) == expected);
  CHECK_FALSE(form(flipped(box({0, 0, 0}, {5, 5, 5}))) == expected);
}

TEST_CASE("the form is complete and readable as text", "[mesh]") {
  CHECK(form(corner_tetrahedron()).text() ==
        "4 vertices\n0: 0 0 0\n1: 0 0 1\n2: 0 1 0\n3: 1 0 0\n4 planes\n"
        "-1 x + 0 y + 0 z = 0\n  0 1 2\n0 x + -1 y + 0 z = 0\n  0 3 1\n0 x + 0 y + -1 z = 0\n  0 2 3\n"
        "1 x + 1 y + 1 z = 1\n  1 3 2\n");
}

TEST_CASE("the form does not depend on the order of faces, corners and vertices", "[mesh]") {
  std::mt19937 random(1);
  const Mesh mesh = shattered(pierced_cube());
  const CanonicalForm expected = form(mesh);
  for (int round = 0; round < 20; ++round) {
    Mesh shuffled = mesh;
    std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
    for (Triangle& t : shuffled.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    CHECK(form(shattered(shuffled)) == expected);
  }
}

TEST_CASE("a hole through a box gives facets with clockwise loops", "[mesh]") {
  const CanonicalForm pierced = form(pierced_cube());
  CHECK(pierced.vertices.size() == 16);
  CHECK(pierced.facet_count() == 10);
  CHECK(pierced.edge_count() == 24);
  std::size_t loops = 0;
  for (const CanonicalFacets& facets : pierced.planes) loops += facets.loops.size();
  CHECK(loops == 12);
  // The same as a box less a prism, as polygons with holes.
  const Mesh cube = box({0, 0, 0}, {4, 4, 4}), plug = flipped(box({1, 1, 0}, {3, 3, 4}));
  CHECK(form(joined(cube, plug)) == pierced);  // the lids of the plug cancel parts of the cube's faces
}

TEST_CASE("solids that share a face are equal to their union: the wall between them cancels", "[mesh]") {
  const CanonicalForm expected = form(box({0, 0, 0}, {2, 1, 1}));
  CHECK(form(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}))) == expected);
  CHECK(form(joined(gridded_box({0, 0, 0}, {1, 1, 1}, 3, true), gridded_box({1, 0, 0}, {2, 1, 1}, 4, true))) ==
        expected);
}

TEST_CASE("a solid and its reverse cancel altogether", "[mesh]") {
  const CanonicalForm nothing =
      form(joined(gridded_box({0, 0, 0}, {5, 5, 5}, 3, true), flipped(box({0, 0, 0}, {5, 5, 5}))));
  CHECK(nothing == CanonicalForm{});
  CHECK(nothing.facet_count() == 0);
  CHECK(nothing == form({}));
}

TEST_CASE("a small box on a large one leaves a hole in the large one's lid", "[mesh]") {
  const CanonicalForm tower = form(joined(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 4}, {2, 3, 5})));
  CHECK(tower.vertices.size() == 16);
  CHECK(tower.facet_count() == 11);
  const CanonicalForm corner = form(joined(box({0, 0, 0}, {4, 4, 4}), box({0, 0, 4}, {2, 3, 5})));
  CHECK(corner.facet_count() == 9);     // two walls go on straight
  CHECK(corner.vertices.size() == 14);  // two of the large one's corners vanish into edges
}

TEST_CASE("prisms that touch crosswise leave facets cut at the exact crossings", "[mesh]") {
  const auto square = prism({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 0, 1);
  const auto turned =
      prism({{Rational(3, 2), -1}, {4, Rational(3, 2)}, {Rational(3, 2), 4}, {-1, Rational(3, 2)}}, 1, 2);
  const CanonicalForm both = canonical_form(concatenated(square, turned));
  CHECK(both.facet_count() == 1 + 1 + 4 + 4 + 4 + 4);
  CHECK(both.vertices.size() == 16 + 8);
  CHECK(std::find(both.vertices.begin(), both.vertices.end(), point(Rational(1, 2), 0, 1)) != both.vertices.end());
}

TEST_CASE("facets that touch at a vertex only are two facets", "[mesh]") {
  const CanonicalForm two = form(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})));
  CHECK(two.facet_count() == 12);
  CHECK(two.vertices.size() == 14);
  CHECK(two.edge_count() == 23);
  for (const CanonicalFacets& facets : two.planes) {
    for (const auto& loop : facets.loops) CHECK(loop.size() == 4);
  }
}

TEST_CASE("a hole that touches the outline belongs to the outer loop, whether or not the outline is cut there",
          "[mesh]") {
  const ExactFacet bottom{{point(0, 0, 0), point(0, 4, 0), point(4, 4, 0), point(4, 0, 0)},
                          {point(2, 0, 0), point(3, 2, 0), point(1, 2, 0)}};
  ExactFacet cut = bottom;
  cut[0].push_back(point(2, 0, 0));
  const CanonicalForm whole = canonical_form({bottom});
  CHECK(whole == canonical_form({cut}));
  CHECK(whole.facet_count() == 1);
  REQUIRE(whole.planes.size() == 1);
  CHECK(whole.planes[0].loops.size() == 1);
  CHECK(whole.planes[0].loops[0].size() == 8);
}

TEST_CASE("holes that touch one another at a vertex are no facets", "[mesh]") {
  const ExactFacet facet{{point(-4, -4, 0), point(4, -4, 0), point(4, 4, 0), point(-4, 4, 0)},
                         {point(0, 0, 0), point(1, 2, 0), point(2, 1, 0)},
                         {point(0, 0, 0), point(2, -1, 0), point(1, -2, 0)}};
  const CanonicalForm form = canonical_form({facet});
  CHECK(form.facet_count() == 1);
  CHECK(form.planes[0].loops.size() == 2);
}

TEST_CASE("an island in a hole is a facet of its own", "[mesh]") {
  const auto frame = [](int r) {
    return std::vector<std::pair<Rational, Rational>>{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  };
  auto facets = concatenated(prism(frame(3), 0, 1), prism(frame(1), 0, 1));
  for (ExactFacet facet : prism(frame(2), 0, 1)) {
    for (auto& loop : facet) std::reverse(loop.begin(), loop.end());
    facets.push_back(facet);
  }
  CHECK(canonical_form(facets).facet_count() == 2 * 2 + 3 * 4);
}

TEST_CASE("coordinates in thirds are as good as doubles", "[mesh]") {
  const auto cube =
      prism({{0, 0}, {Rational(1, 3), 0}, {Rational(1, 3), Rational(2, 3)}, {0, Rational(2, 3)}}, 0, Rational(1, 3));
  const CanonicalForm expected = canonical_form(cube);
  ExactMesh mesh{box({0, 0, 0}, {1.0 / 3, 2.0 / 3, 1.0 / 3}), {}};
  for (std::uint32_t v = 1; v < 8; ++v) {
    mesh.exact.push_back(
        {v, point(Rational(v & 1 ? 1 : 0, 3), Rational(v & 2 ? 2 : 0, 3), Rational(v & 4 ? 1 : 0, 3))});
  }
  CHECK(canonical_form(mesh) == expected);
  CHECK(expected.planes.back().plane.coefficients == std::array<Integer, 4>{3, 0, 0, 1});
  CHECK_FALSE(canonical_form(ExactMesh{mesh.mesh, {}}) == expected);
}

TEST_CASE("coordinates may be as small and as large as doubles are", "[mesh]") {
  for (const double size : {1e-300, 1e300, 5e-324}) {
    const CanonicalForm small = form(box({-1e300, 0, 0}, {size, size, 1}));
    CHECK(small.facet_count() == 6);
    CHECK(form(shattered(box({-1e300, 0, 0}, {size, size, 1}))) == small);
  }
  CHECK(form(joined(box({-1e300, 0, 0}, {1e-300, 1, 1}), box({1e-300, 0, 0}, {1e300, 1, 1}))) ==
        form(box({-1e300, 0, 0}, {1e300, 1, 1})));
}

TEST_CASE("minus zero is zero in a canonical form", "[mesh]") {
  CHECK(form(box({-0.0, -0.0, -0.0}, {1, 1, 1})) == form(box({0, 0, 0}, {1, 1, 1})));
}

TEST_CASE("facets of zero area are ignored", "[mesh]") {
  Mesh mesh = box({0, 0, 0}, {2, 2, 2});
  mesh.vertices.push_back({1, 0, 0});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 8, 1}, {0, 0, 5}, {3, 3, 3}});
  CHECK(form(mesh) == form(box({0, 0, 0}, {2, 2, 2})));
}

TEST_CASE("boundaries with non-manifold edges have one form", "[mesh]") {
  const Mesh welded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
                    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 5, 4}, {0, 4, 3}, {0, 3, 5}, {4, 5, 3}}};
  CHECK(form(welded).facet_count() == 8);
  CHECK(form(welded) == form(shattered(welded)));
  CHECK(form(welded).edge_count() == 11);
}

TEST_CASE("a plane covered twice keeps both layers", "[mesh]") {
  const Mesh cube = box({0, 0, 0}, {2, 2, 2});
  const CanonicalForm twice = form(joined(cube, cube));
  CHECK(twice.facet_count() == 12);
  CHECK(form(joined(cube, joined(flipped(cube), cube))) == form(cube));
}

TEST_CASE("a mesh divided at random has the form of the mesh", "[mesh][property]") {
  const auto seed = GENERATE(take(30, random(0, 1'000'000)));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  const Mesh coarse = joined(pierced_cube(), box({1, 1, 4}, {2, 3, 8}));
  Mesh fine = shattered(scaled(coarse, 1 << 12));
  for (int step = 0; step < 200; ++step) {  // a triangle is divided from a corner to the middle of a side: T-junctions
    Triangle& t = fine.triangles[random() % fine.triangles.size()];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    const Vertex a = fine.vertices[t[0]], b = fine.vertices[t[1]];
    const Vertex m{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    const auto i = static_cast<std::uint32_t>(fine.vertices.size());
    fine.vertices.push_back(m);
    const Triangle other{i, t[1], t[2]};
    t[1] = i;
    fine.triangles.push_back(other);
  }
  CHECK(form(fine) == form(scaled(coarse, 1 << 12)));
}

TEST_CASE("a polygon that is not planar is refused", "[mesh]") {
  const ExactFacet bent{{point(0, 0, 0), point(1, 0, 0), point(1, 1, 1), point(0, 1, 0)}};
  CHECK_THROWS_AS(canonical_form({bent}), std::invalid_argument);
}

TEST_CASE("two hundred thousand triangles take a few seconds", "[mesh][slow]") {
  const Mesh round = globe(320), flat = gridded_box({0, 0, 0}, {128, 128, 128}, 128, true);
  for (const Mesh& mesh : {round, flat}) {
    const auto start = std::chrono::steady_clock::now();
    const CanonicalForm result = form(mesh);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    WARN(mesh.triangles.size() << " triangles, " << result.facet_count() << " facets: " << seconds.count() << " s");
    CHECK(seconds.count() < 20);
  }
}
