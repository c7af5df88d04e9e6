#include "core/mesh/fill_holes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "core/mesh/prepare.h"
#include "mesh/shapes.h"
#include "strata/measure.h"

using namespace strata;
using namespace strata::shapes;

namespace {

SourcedTriangles sourced(const Mesh& mesh) {
  SourcedTriangles faces;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) faces.add(mesh.triangles[f], f);
  return faces;
}

Rational filled_volume(const Mesh& mesh) {
  const Prepared p = prepare_soup(mesh, Holes::filled);
  REQUIRE(chain_is_closed(*p.mesh));
  return volume(ExactMesh{*p.mesh, {}});
}

Mesh cube() { return box({0, 0, 0}, {1, 1, 1}); }

Mesh without(Mesh mesh, std::initializer_list<std::size_t> faces) {
  for (auto f = std::rbegin(faces); f != std::rend(faces); ++f)
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(*f));
  return mesh;
}

}  // namespace

TEST_CASE("what is missing of a cube is filled", "[mesh]") {
  CHECK(filled_volume(without(cube(), {11})) == 1);
  CHECK(filled_volume(without(cube(), {0, 1})) == 1);
  CHECK(filled_volume(without(cube(), {0, 1, 2, 3})) == 1);  // a tube
  CHECK(filled_volume(shattered(without(cube(), {4, 5, 6}))) == 1);
  CHECK(filled_volume(flipped(without(cube(), {4, 5, 6}))) == 1);
}

TEST_CASE("holes are found with their loops and a face beside them", "[mesh]") {
  SourcedTriangles faces = sourced(without(cube(), {0, 1, 2, 3}));
  CHECK(open_uses(cube().vertices, faces.triangles) == 8);
  const std::vector<Hole> holes = find_holes(cube().vertices, faces);
  fill_holes(cube().vertices, holes, faces);
  REQUIRE(holes.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(holes[i].loop.size() == 4);
    CHECK(faces.sources[8 + 2 * i] == holes[i].face_beside);
  }
  CHECK(faces.triangles.size() == 12);
  CHECK(open_uses(cube().vertices, faces.triangles) == 0);
  CHECK(find_holes(cube().vertices, faces).empty());
}

TEST_CASE("a closed mesh keeps its orientation, cavities too", "[mesh]") {
  const Mesh hollow = joined(box({0, 0, 0}, {3, 3, 3}), flipped(box({1, 1, 1}, {2, 2, 2})));
  CHECK(filled_volume(hollow) == 26);
  CHECK(filled_volume(flipped(hollow)) == 26);
  CHECK(filled_volume(joined(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2}))) == 28);  // covered twice
}

TEST_CASE("no shell is lost because it is inside out", "[mesh]") {
  const Mesh far = box({5, 0, 0}, {6, 1, 1});
  CHECK(filled_volume(joined(cube(), flipped(far))) == 2);
  CHECK(filled_volume(joined(box({0, 0, 0}, {3, 3, 3}), flipped(far))) == 28);
  CHECK(filled_volume(joined(without(cube(), {11}), flipped(far))) == 2);
  CHECK(filled_volume(joined(cube(), flipped(box({5, 0, 0}, {9, 4, 4})))) == 65);
  // A nested shell oriented alike is covered twice, also where another sheet has a face that is turned.
  Mesh turned = far;
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  const Mesh nested = joined(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2}));
  CHECK(filled_volume(joined(nested, turned)) == 29);
}

TEST_CASE("faces that run against their neighbours are turned before holes are filled", "[mesh]") {
  Mesh mesh = without(cube(), {11});
  for (const std::size_t f : {1U, 4U, 7U}) std::swap(mesh.triangles[f][0], mesh.triangles[f][1]);
  CHECK(filled_volume(mesh) == 1);
}

TEST_CASE("a T-junction is closed by a triangle without area", "[mesh]") {
  Mesh mesh = cube();
  // The edge 0-1 of one of its faces gets a vertex in its middle.
  mesh.vertices.push_back({0.5, 0, 0});
  const auto has_edge = [](const Triangle& t, std::size_t i) { return t[i] == 0 && t[(i + 1) % 3] == 1; };
  for (std::size_t f = 0; f < 12; ++f)
    for (std::size_t i = 0; i < 3; ++i)
      if (has_edge(mesh.triangles[f], i)) {
        const std::uint32_t c = mesh.triangles[f][(i + 2) % 3];
        mesh.triangles[f] = {0, 8, c};
        mesh.triangles.push_back({8, 1, c});
        break;
      }
  REQUIRE(mesh.triangles.size() == 13);
  CHECK(filled_volume(mesh) == 1);
}

TEST_CASE("what encloses nothing is refused", "[mesh]") {
  const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK_THROWS_AS(prepare_soup(triangle, Holes::filled), InputError);
  const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  CHECK_THROWS_AS(prepare_soup(square, Holes::filled), InputError);
}

TEST_CASE("a fold that its own filling would cancel encloses something", "[mesh]") {
  // Two triangles, folded: the other diagonal makes a tetrahedron, this one nothing.
  const Mesh folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}}};
  CHECK(filled_volume(folded) == Rational(1, 6));
  // The sides of a pyramid, but for one of them: least area would cover two sides again.
  const Mesh pyramid{{{0, 0, 5}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
  CHECK(filled_volume(pyramid) == Rational(20, 3));
}

TEST_CASE("a model whose faces are listed for both sides encloses what one of each does", "[mesh]") {
  CHECK(filled_volume(joined(cube(), flipped(cube()))) == 1);
  CHECK(filled_volume(joined(without(cube(), {11}), flipped(without(cube(), {11})))) == 1);
  // A wall that is listed twice within a solid is no boundary.
  const Mesh beside = joined(cube(), box({1, 0, 0}, {2, 1, 1}));
  CHECK(filled_volume(beside) == 2);
}

TEST_CASE("holes of many edges are refused by name", "[mesh]") {
  const Mesh open = without(cube(), {0, 1, 11});
  REQUIRE(prepare_soup(open, Holes::filled, 0, 4).mesh);
  try {
    (void)prepare_soup(open, Holes::filled, 0, 3);
    FAIL("a hole of four edges was filled");
  } catch (const InputError& error) {
    REQUIRE(error.defects().size() == 2);
    CHECK(error.defects()[0].severity == Severity::error);
    CHECK(error.defects()[0].message == "a hole is bounded by 4 open edges");
    CHECK(error.defects()[1].severity == Severity::note);  // the hole of three edges
  }
}

TEST_CASE("a loop that comes back to a vertex is two loops", "[mesh]") {
  // Two opposite corners of one side of a fan: the fan's missing triangles touch in its middle vertex.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}};
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back({std::cos(i * 0.785), std::sin(i * 0.785), 0.0});
  mesh.vertices.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t a = 1 + i, b = 1 + (i + 1) % 8;
    if (i != 0 && i != 4) mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({9, b, a});
  }
  SourcedTriangles faces = sourced(mesh);
  const std::vector<Hole> holes = find_holes(mesh.vertices, faces);
  fill_holes(mesh.vertices, holes, faces);
  REQUIRE(holes.size() == 2);
  CHECK(holes[0].loop.size() == 3);
  CHECK(holes[1].loop.size() == 3);
  CHECK(open_uses(mesh.vertices, faces.triangles) == 0);
}

TEST_CASE("long loops", "[mesh]") {
  const Mesh globe = shapes::globe(400);
  Mesh lower = globe;
  std::erase_if(lower.triangles, [&](const Triangle& t) {
    return globe.vertices[t[0]][2] + globe.vertices[t[1]][2] + globe.vertices[t[2]][2] > 0;
  });
  SourcedTriangles faces = sourced(lower);
  const std::vector<Hole> holes = find_holes(lower.vertices, faces);
  fill_holes(lower.vertices, holes, faces);
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].loop.size() >= 400);
  CHECK(faces.triangles.size() == lower.triangles.size() + holes[0].loop.size() - 2);
  const double half = to_nearest_double(volume(ExactMesh{globe, {}})) / 2;
  CHECK(to_nearest_double(filled_volume(lower)) == Approx(half).epsilon(0.01));
}

TEST_CASE("whatever faces are missing, the chain is closed", "[mesh][property]") {
  const Mesh whole = joined(globe(12), joined(box({2, 0, 0}, {3, 1, 1}), box({3, 1, 0}, {4, 2, 1})));
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Mesh mesh = whole;
    std::erase_if(mesh.triangles, [&](const Triangle&) { return random() % (2 + seed % 20) == 0; });
    if (seed % 3 == 0)
      for (Triangle& t : mesh.triangles)
        if (random() % 2 == 0) std::swap(t[0], t[1]);
    if (seed % 5 == 0) mesh = shattered(mesh);
    SourcedTriangles faces = sourced(mesh);
    fill_holes(mesh.vertices, find_holes(mesh.vertices, faces), faces);
    REQUIRE(open_uses(mesh.vertices, faces.triangles) == 0);
    const Prepared p = prepare_soup(mesh, Holes::filled);
    REQUIRE(chain_is_closed(*p.mesh));
    REQUIRE(volume(ExactMesh{*p.mesh, {}}) > 0);
    if (seed % 3 != 0 && seed % 20 > 10)
      REQUIRE(to_nearest_double(volume(ExactMesh{*p.mesh, {}})) ==
              Approx(to_nearest_double(volume(ExactMesh{whole, {}}))).epsilon(0.1));
  }
}
