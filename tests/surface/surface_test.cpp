#include "strata/surface.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>

#include "strata/check.h"
#include "strata/primitives.h"
#include "support/shapes.h"

using namespace strata;

namespace {

Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }

/// A rectangle in a plane z = height.
Surface sheet(double x0, double y0, double x1, double y1, double height) {
  Mesh mesh;
  mesh.vertices = {{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return Surface(mesh);
}

Mesh joined(Mesh a, const Mesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

Rational total_volume(const std::vector<Solid>& solids) {
  Rational sum = 0;
  for (const Solid& s : solids) sum += s.volume();
  return sum;
}

std::vector<Rational> volumes(const std::vector<Solid>& solids) {
  std::vector<Rational> list;
  for (const Solid& s : solids) list.push_back(s.volume());
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Rational> rationals(std::initializer_list<int> list) { return {list.begin(), list.end()}; }

}  // namespace

TEST_CASE("a surface takes any triangles and leaves out what has no area", "[surface]") {
  Mesh mesh = sheet(0, 0, 1, 1, 0).mesh();
  mesh.vertices.push_back({0, 0, -0.0});
  mesh.vertices.push_back({2, 0, 0});
  mesh.triangles.push_back({0, 1, 5});  // collinear
  mesh.triangles.push_back({0, 4, 1});  // two corners at one place
  const Surface surface(mesh);
  CHECK(surface.mesh().triangles.size() == 2);
  CHECK(surface.mesh().vertices.size() == 4);
  CHECK(surface.area() == 1);
  REQUIRE(surface.notes().size() == 2);
  CHECK(surface.notes().front().kind == DefectKind::degenerate_triangle);
  CHECK(surface.notes().front().severity == Severity::note);

  mesh.triangles.push_back({0, 1, 99});
  CHECK_THROWS_AS(Surface(mesh), InputError);
  mesh.triangles.back() = {0, 1, 2};
  mesh.vertices[2][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Surface(mesh), InputError);
  CHECK(Surface().is_empty());
  CHECK(Surface(Mesh{}).is_empty());
  CHECK_THROWS_AS(Surface(ExactMesh{surface.mesh(), {{0, {Rational(1, 3), 0, 0}}}}), std::invalid_argument);
}

TEST_CASE("nothing divides nothing", "[surface]") {
  CHECK(arrange({}).cell_count == 1);
  CHECK(cells_of({}).empty());
  CHECK(cells_of(std::vector{Surface(), Surface()}).empty());
  CHECK(split(Solid(), std::vector{sheet(0, 0, 1, 1, 0)}).empty());
  CHECK(clip(Surface(), box({0, 0, 0}, {1, 1, 1}), ClipTo::inside).is_empty());
  CHECK(clip(sheet(0, 0, 1, 1, 0), Solid(), ClipTo::outside).area() == 1);
  CHECK(imprint(std::vector{Surface(), sheet(0, 0, 1, 1, 0)})[1].area() == 1);
  CHECK(imprint({}).empty());
}

TEST_CASE("a sheet splits a box, exactly in the middle of nowhere", "[surface]") {
  const Solid solid = box({0, 0, 0}, {3, 3, 3});
  const std::vector<Solid> pieces = split(solid, std::vector{sheet(-1, -1, 4, 4, 1)});
  CHECK(volumes(pieces) == rationals({9, 18}));
  CHECK(union_(pieces) == solid);
  for (const Solid& piece : pieces) CHECK(check(piece.exact_mesh()).empty());
}

TEST_CASE("a sheet that ends inside a solid does not split it", "[surface]") {
  const Solid solid = box({0, 0, 0}, {3, 3, 3});
  const std::vector<Solid> pieces = split(solid, std::vector{sheet(-1, -1, 2, 4, 1)});
  REQUIRE(pieces.size() == 1);
  CHECK(pieces.front() == solid);
  CHECK(split(solid, std::vector{sheet(1, 1, 2, 2, 1)}).size() == 1);
  // Two such sheets that meet in an edge do.
  CHECK(split(solid, std::vector{sheet(-1, -1, 2, 4, 1), sheet(2, -1, 4, 4, 1)}).size() == 2);
  // With a slit between them they do not.
  CHECK(split(solid, std::vector{sheet(-1, -1, 2, 4, 1), sheet(2.0000000000000004, -1, 4, 4, 1)}).size() == 1);
}

TEST_CASE("planes split a box into a grid", "[surface]") {
  const Solid solid = box({0, 0, 0}, {3, 3, 3});
  std::vector<Surface> planes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int at : {1, 2}) {
      RationalPoint normal{0, 0, 0};
      normal[axis] = axis == 1 ? -1 : 1;
      planes.push_back(Surface::of_plane({normal, axis == 1 ? -at : at}, solid.bounding_box()));
    }
  const std::vector<Solid> pieces = split(solid, planes);
  CHECK(pieces.size() == 27);
  CHECK(total_volume(pieces) == 27);
  for (const Solid& piece : pieces) CHECK(piece.volume() == 1);
  for (const Source& source : pieces.front().sources()) CHECK(source.operand <= 6);
}

TEST_CASE("a plane through a vertex, an edge, a face, and beside", "[surface]") {
  const Solid solid = box({0, 0, 0}, {1, 1, 1});
  const auto pieces = [&](const RationalPoint& normal, const Rational& offset) {
    return split(solid, std::vector{Surface::of_plane({normal, offset}, solid.bounding_box())}).size();
  };
  CHECK(pieces({1, 1, 1}, 3) == 1);
  CHECK(pieces({1, 1, 0}, 2) == 1);
  CHECK(pieces({0, 0, 1}, 1) == 1);
  CHECK(pieces({0, 0, 1}, 5) == 1);
  CHECK(pieces({1, 1, 1}, Rational(1, 3)) == 2);
  CHECK(pieces({1, -1, 0}, 0) == 2);
  CHECK_THROWS_AS(pieces({0, 0, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(Surface::of_plane({{1, 1, 1}, 0}, {{0, 0, 0}, {1e308, 1e308, 1e308}}), std::overflow_error);
}

TEST_CASE("clipping by a box", "[surface]") {
  const Solid solid = box({0, 0, 0}, {2, 2, 2});
  const Surface across = sheet(-1, -1, 3, 3, 1), on = sheet(-1, -1, 3, 3, 2);
  CHECK(clip(across, solid, ClipTo::inside).area() == 4);
  CHECK(clip(across, solid, ClipTo::outside).area() == 12);
  CHECK(clip(across, solid, ClipTo::on).is_empty());
  CHECK(clip(on, solid, ClipTo::on).area() == 4);
  CHECK(clip(on, solid, ClipTo::inside).is_empty());
  CHECK(clip(on, solid, ClipTo::outside).area() == 12);
  const Surface part = clip(on, solid, ClipTo::on);
  for (const Source& source : part.sources()) CHECK(source.operand == 0);
  // A surface given twice counts once.
  Mesh twice = joined(across.mesh(), across.mesh());
  CHECK(clip(Surface(twice), solid, ClipTo::inside).area() == 4);
}

TEST_CASE("imprinting adds edges and nothing else", "[surface]") {
  const std::vector surfaces{sheet(0, 0, 2, 2, 0), sheet(1, 1, 3, 3, 0), Surface(box({0, 0, -1}, {1, 1, 1}))};
  const std::vector<Surface> result = imprint(surfaces);
  for (std::size_t k = 0; k < 3; ++k) CHECK(result[k].area() == surfaces[k].area());
  // What coincides has the same triangles: the square [1, 2] x [1, 2], and nothing is left to divide.
  const Arrangement again = arrange(result);
  std::size_t triangles = 0;
  for (const Surface& s : result) triangles += s.mesh().triangles.size();
  CHECK(again.mesh.mesh.triangles.size() + again.covers.size() == triangles);
  CHECK_FALSE(again.covers.empty());
  CHECK(again.cell_count == 3);
}

TEST_CASE("cells of boxes that share faces, edges and nothing", "[surface]") {
  const std::vector surfaces{Surface(box({0, 0, 0}, {1, 1, 1})), Surface(box({1, 0, 0}, {2, 1, 1})),
                             Surface(box({2, 1, 0}, {3, 2, 1})), Surface(box({5, 5, 5}, {6, 6, 6}))};
  const Arrangement a = arrange(surfaces);
  CHECK(a.cell_count == 5);
  CHECK(a.covers.size() == 2);  // the common face: two triangles
  for (const Arrangement::Cover& c : a.covers) {
    CHECK(c.face.operand == 1);
    CHECK(c.is_reversed);
  }
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::vector<std::int32_t> w = a.windings(k);
    CHECK(std::accumulate(w.begin(), w.end(), 0) == 1);
    CHECK(w[0] == 0);
  }
  CHECK(volumes(a.solids()) == rationals({1, 1, 1, 1}));
}

TEST_CASE("nested boxes are cells with cavities", "[surface]") {
  const std::vector surfaces{Surface(box({0, 0, 0}, {9, 9, 9})), Surface(box({1, 1, 1}, {8, 8, 8})),
                             Surface(box({2, 2, 2}, {3, 3, 3})), Surface(box({4, 4, 4}, {7, 7, 7})),
                             Surface(box({5, 5, 5}, {6, 6, 6})), sheet(5.25, 5.25, 5.75, 5.75, 5.5)};
  const Arrangement a = arrange(surfaces);
  CHECK(a.cell_count == 6);
  const std::vector<Solid> solids = a.solids();
  CHECK(volumes(solids) == rationals({1, 1, 26, 343 - 28, 729 - 343}));
  for (const Solid& s : solids) CHECK(check(s.exact_mesh()).empty());
  CHECK_THROWS_AS(a.windings(5), std::invalid_argument);
  // Walls that lie inside a cell have it on both sides.
  for (std::size_t w = 0; w < a.cells.size(); ++w)
    CHECK((a.sources[w].operand == 5) == (a.cells[w][0] == a.cells[w][1]));
}

TEST_CASE("boxes within boxes, two hundred deep", "[surface]") {
  std::vector<Surface> surfaces;
  for (int i = 200; i > 0; --i) {
    const double r = i;
    surfaces.emplace_back(box({-r, -r, -r}, {r, r, r}));
  }
  const std::vector<Solid> shells = cells_of(surfaces);
  CHECK(shells.size() == 200);
  CHECK(total_volume(shells) == 64'000'000);
}

TEST_CASE("planes in all directions through a solid far from the origin", "[surface]") {
  const Solid solid = box({500000.25, 4000000.5, 100}, {500010.25, 4000010.5, 110});
  std::vector<Surface> planes;
  for (int i = 0; i < 12; ++i) {
    const RationalPoint normal{Rational(i % 5 - 2, 3), Rational(i % 7 - 3, 5), Rational(1 + i % 3)};
    const Rational through = normal[0] * Rational(500005) + normal[1] * Rational(4000005) + normal[2] * Rational(105);
    planes.push_back(Surface::of_plane({normal, through + Rational(i, 7)}, solid.bounding_box()));
  }
  const std::vector<Solid> pieces = split(solid, planes);
  CHECK(pieces.size() > 50);
  CHECK(total_volume(pieces) == 1000);
}

TEST_CASE("open sheets enclose a cell together", "[surface]") {
  std::vector<Surface> sides;
  const Mesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
    sides.push_back(Surface(Mesh{mesh.vertices, {mesh.triangles[t], mesh.triangles[t + 1]}}));
  CHECK(cells_of(sides).size() == 1);
  CHECK(cells_of(sides).front() == Solid(mesh));
  sides.pop_back();
  CHECK(cells_of(sides).empty());
}

TEST_CASE("a Moebius band cuts a cube", "[surface]") {
  // A band of half-turn around the z axis; both ends of it are the same segment, turned round.
  Mesh band;
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i) {
    const double u = 2 * 3.141592653589793 * i / steps, half = u / 2;
    for (const double v : {-1.0, 1.0})
      band.vertices.push_back(
          {(3 + v * std::cos(half)) * std::cos(u), (3 + v * std::cos(half)) * std::sin(u), v * std::sin(half)});
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1;
    const bool last = i + 1 == steps;
    const std::uint32_t c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    band.triangles.push_back({a, b, d});
    band.triangles.push_back({a, d, c});
  }
  const Surface surface(band);
  const Solid cube = box({0, -2, -2}, {4, 2, 2});
  const double in = clip(surface, cube, ClipTo::inside).area(), out = clip(surface, cube, ClipTo::outside).area();
  CHECK(in > 0);
  CHECK(out > 0);
  CHECK(in + out == Approx(surface.area()).epsilon(1e-12));
  const std::vector<Solid> pieces = split(cube, std::vector{surface});
  CHECK(total_volume(pieces) == cube.volume());
  CHECK(union_(pieces) == cube);
}

TEST_CASE("a thousand coincident sheets are one", "[surface]") {
  Mesh many;
  for (int i = 0; i < 1000; ++i) many = joined(std::move(many), sheet(0, 0, 1, 1, 0).mesh());
  const Surface surface(many);
  CHECK(surface.mesh().vertices.size() == 4);
  const Arrangement a = arrange(std::vector{surface});
  CHECK(a.mesh.mesh.triangles.size() == 2);
  CHECK(a.covers.size() == 1998);
  CHECK(split(box({0, 0, -1}, {1, 1, 1}), std::vector{surface}).size() == 2);
}

TEST_CASE("two surfaces with all boundary edges in common enclose a lens", "[surface]") {
  const auto tent = [](double height) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, height}};
    mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    return Surface(mesh);
  };
  const std::vector<Solid> lens = cells_of(std::vector{tent(3), tent(-3)});
  REQUIRE(lens.size() == 1);
  CHECK(lens.front().volume() == 8);
  CHECK(cells_of(std::vector{tent(3), tent(3)}).empty());
}

TEST_CASE("the same for any number of threads", "[surface]") {
  const std::vector surfaces{Surface(make_sphere(1, 24)),
                             Surface(make_sphere(1, 16).translated({Rational(1, 3), 0, 0})), sheet(-2, -2, 2, 2, 0.25),
                             sheet(-2, -2, 2, 2, 0)};
  const Arrangement one = arrange(surfaces, {.threads = 1}), two = arrange(surfaces, {.threads = 2});
  CHECK(one.mesh.mesh == two.mesh.mesh);
  CHECK(one.sources == two.sources);
  CHECK(one.cells == two.cells);
}

TEST_CASE("an arrangement can be cancelled, and reports progress", "[surface]") {
  CancelToken token;
  token.cancel();
  const std::vector surfaces{sheet(0, 0, 1, 1, 0)};
  CHECK_THROWS_AS(arrange(surfaces, {.cancel = &token}), Cancelled);
  CHECK_THROWS_AS(imprint(surfaces, {.cancel = &token}), Cancelled);
  CHECK_THROWS_AS(Surface(surfaces[0].exact_mesh(), Monitor(&token)), Cancelled);
  double last = 0;
  const Arrangement a = arrange(surfaces, {.progress = [&](double f) { last = f; }});
  CHECK(last == 1);
  CHECK(a.cell_count == 1);
}
