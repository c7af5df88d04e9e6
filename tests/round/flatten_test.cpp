#include "core/round/flatten.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numeric>

#include "core/mesh/prepare.h"
#include "core/round/distances.h"
#include "core/round/pile_filling.h"
#include "core/round/viewed_plane.h"
#include "support/append.h"
#include "support/shapes.h"

using namespace strata;

namespace {

MovingMesh moving(Mesh mesh) {
  std::vector<std::uint32_t> source(mesh.triangles.size());
  std::iota(source.begin(), source.end(), 0U);
  const std::size_t count = source.size();
  return MovingMesh(std::move(mesh), std::move(source), std::vector<double>(count, 0));
}

/// Changes all of it in place, as if it had been rounded, so that it is the region.
MovingMesh changed(const Mesh& mesh) {
  MovingMesh result = moving(mesh);
  std::vector<VertexMove> moves;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) moves.push_back({v, v, mesh.vertices[v], 0x1p-53});
  result.move(moves);
  return result;
}

std::vector<std::uint32_t> all_of(const Mesh& mesh) {
  std::vector<std::uint32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

}  // namespace

TEST_CASE("of a plate thinner than the reach nothing is left, of a cube all", "[round]") {
  const GridRounding grid({CoordinateGrid::Format::float64, 1});
  for (const double height : {0.5, 3.0, 100.0}) {
    const Mesh plate = test::box({0, 0, 0}, {100, 100, height});
    MovingMesh mesh = changed(plate);
    const ChangedRegion region(mesh, {});
    CHECK(flatten(mesh, region, all_of(plate), grid, 4, false) == (height < 4));
    const MovingMesh::Parts parts = std::move(mesh).take();
    CHECK(parts.mesh.triangles.size() == (height < 4 ? 0 : 12));
  }
}

TEST_CASE("where a thin plate stands on a block, its base is closed", "[round]") {
  // The plate's side faces are wrong with its top; what is left has the boundary of what it covered.
  Mesh block = test::cube_grid(6);
  for (Vertex& v : block.vertices)
    if (v[2] == 6 && v[0] > 1 && v[0] < 5 && v[1] > 1 && v[1] < 5) v[2] = 6 + 0x1p-49;
  MovingMesh mesh = changed(block);
  std::vector<std::uint32_t> upper;
  for (std::uint32_t f = 0; f < block.triangles.size(); ++f) {
    const Triangle& t = block.triangles[f];
    if (block.vertices[t[0]][2] >= 6 && block.vertices[t[1]][2] >= 6 && block.vertices[t[2]][2] >= 6)
      upper.push_back(f);
  }
  const ChangedRegion region(mesh, {});
  REQUIRE(flatten(mesh, region, upper, GridRounding({}), 4, false));
  const MovingMesh::Parts parts = std::move(mesh).take();
  CHECK(parts.mesh.triangles.size() < block.triangles.size());
  CHECK(chain_is_closed(parts.mesh));
  for (const Vertex& v : parts.mesh.vertices) CHECK(v[2] <= 6);
}

TEST_CASE("vertices of a boundary that are seen as one become one", "[round]") {
  // Upper and lower faces of a plate whose sides are not in the pile: as they are seen, they cancel.
  const Mesh plate = test::box({0, 0, 0}, {100, 100, 1});
  std::vector<std::uint32_t> horizontal;
  for (std::uint32_t f = 0; f < plate.triangles.size(); ++f) {
    const auto& [a, b, c] = plate.triangles[f];
    if (plate.vertices[a][2] == plate.vertices[b][2] && plate.vertices[b][2] == plate.vertices[c][2])
      horizontal.push_back(f);
  }
  REQUIRE(horizontal.size() == 4);
  const ViewedPlane plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
  const auto filling = filling_of(plate, horizontal, plane, GridRounding({}), 0);
  REQUIRE(filling);
  CHECK(filling->triangles.empty());
  CHECK(filling->joined.size() == 4);
  for (const VertexMove& m : filling->joined) {
    CHECK(m.becomes < m.vertex);
    CHECK(m.to == plate.vertices[m.becomes]);
    CHECK(m.way >= 1);
  }
}

TEST_CASE("the corners of a needle are in its plane", "[round]") {
  // Doubles lose its normal: the two products of each component are nearly equal.
  const std::array<Vertex, 3> needle{{{1, -0.9795814163637189, -0.38927029147619485},
                                      {-1, 0.5501029582052583, 0.8991650829991871},
                                      {1, -0.9795814163637422, -0.3892702914761672}}};
  for (const int exponent : {-1000, 0, 1020}) {
    std::array<Vertex, 3> corners = needle;
    for (Vertex& v : corners)
      for (double& x : v) x = std::ldexp(x, exponent);
    const ViewedPlane plane(corners[0], corners[1], corners[2]);
    REQUIRE(plane.is_valid());
    for (const Vertex& v : corners) {
      const Range height = plane.height(v);
      CHECK(std::max(-height.lower, height.upper) <= std::ldexp(1.0, exponent - 63));
      CHECK(plane.may_be_within(v, 0));
    }
    CHECK_FALSE(plane.may_be_within({0, 0, std::ldexp(0.25, exponent)}, std::ldexp(0x1p-30, exponent)));
    const Vertex on = plane.point(corners[1][plane.first()], corners[1][plane.second()]);
    CHECK(distance(on, corners[1]) <= std::ldexp(1.0, exponent - 52));
  }
}

TEST_CASE("a boundary that crosses itself as it is seen is divided at vertices of the grid", "[round]") {
  // Two long plates of a third of a unit that cross, one on the other: the sides of their upper faces cross from above.
  Mesh plates = test::box({0, 40, 0}, {100, 60, 1});
  test::append(plates, test::box({40, 0, 1}, {60, 100, 2}));
  // Without their ends they are no closed piles.
  std::vector<std::uint32_t> horizontal;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t f = 0; f < plates.triangles.size(); ++f) {
    const Triangle& t = plates.triangles[f];
    if (plates.vertices[t[0]][2] == plates.vertices[t[1]][2] && plates.vertices[t[1]][2] == plates.vertices[t[2]][2])
      horizontal.push_back(f);
  }
  MovingMesh mesh = changed(plates);
  ChangedRegion region(mesh, {});
  const auto wrong = region.wrong_faces({});  // the plates touch
  CHECK_FALSE(wrong.empty());
  (void)flatten(mesh, region, horizontal, GridRounding({CoordinateGrid::Format::float64, 1}), 4, false);
  const MovingMesh::Parts parts = std::move(mesh).take();
  CHECK(chain_is_closed(parts.mesh));
}

TEST_CASE("a corner inside of a pile may be seen where sides of its boundary cross", "[round][regression]") {
  // From a union rounded to hundredths. The corner 5, at (30, -78), was taken for the crossing there.
  Mesh mesh{
      {{45, -84, 70},
       {31, -78, 62},
       {31, -76, 61},
       {29, -78, 61},
       {32, -78, 61},
       {30, -78, 60},
       {30, -79, 61},
       {31, -77, 60},
       {30, -77, 60}},
      {{0, 2, 1}, {3, 1, 2}, {7, 4, 5}, {3, 2, 5}, {2, 7, 5}, {6, 8, 3}, {3, 5, 1}, {4, 1, 5}, {1, 4, 3}, {6, 3, 4}}};
  const std::vector<std::uint32_t> pile = all_of(mesh);
  // A cone closes it.
  const auto apex = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({35, -80, 10000});
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  for (const auto& [side, count] : sides)
    for (int n = 0; n < std::abs(count); ++n)
      mesh.triangles.push_back(count > 0 ? Triangle{side.second, side.first, apex}
                                         : Triangle{side.first, side.second, apex});
  REQUIRE(chain_is_closed(mesh));
  MovingMesh all = changed(mesh);
  ChangedRegion region(all, {});
  CHECK_FALSE(region.wrong_faces({}).empty());
  REQUIRE(flatten(all, region, pile, GridRounding({CoordinateGrid::Format::float64, 1}), 2, false));
  const MovingMesh::Parts parts = std::move(all).take();
  CHECK(chain_is_closed(parts.mesh));
}

TEST_CASE("a search that ends early says so", "[round]") {
  Mesh two = test::box({0, 0, 0}, {2, 2, 2});
  const Mesh other = test::box({1, 1, 1}, {3, 3, 3});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const MovingMesh mesh = changed(two);
  ChangedRegion some(mesh, {}), all(mesh, {});
  CHECK_FALSE(some.wrong_faces({}, 1).empty());
  CHECK_FALSE(some.is_complete());
  CHECK_FALSE(all.wrong_faces({}).empty());
  CHECK(all.is_complete());
}

TEST_CASE("triangles that collapse are not searched", "[round]") {
  // A pyramid over a square, one corner of which is cut off by a short side: its ends meet.
  const Mesh pyramid{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0.2, 4, 0}, {0, 3.8, 0}, {1, 1, 4}},
                     {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}, {0, 2, 1}, {0, 3, 2}, {0, 4, 3}}};
  MovingMesh mesh = moving(pyramid);
  mesh.move(std::vector<VertexMove>{{3, 3, {0, 4, 0}, 0.2}, {4, 4, {0, 4, 0}, 0.2}});
  ChangedRegion region(mesh, {});
  CHECK(region.wrong_faces({}).empty());
  CHECK(region.has_collapsed());
  CHECK_FALSE(region.has_area_everywhere());
  CHECK(region.faces() == std::vector<std::uint32_t>{0, 1, 2, 4, 5, 6});
  CHECK(region.equal_vertices() == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{4, 3}});
}

TEST_CASE("once all has moved, a vertex that only gets another number changes no triangle", "[round]") {
  Mesh two = test::box({0, 0, 0}, {1, 1, 1});
  two.vertices.push_back(two.vertices[0]);
  two.triangles[0] = {8, two.triangles[0][1], two.triangles[0][2]};
  REQUIRE(two.vertices[8] == two.vertices[0]);
  MovingMesh mesh = changed(two);
  REQUIRE_FALSE(mesh.swept());
  mesh.set_searched({});
  mesh.move(std::vector<VertexMove>{{8, 0, two.vertices[0], 0}});
  CHECK(mesh.changed().empty());
  CHECK(mesh.mesh().triangles[0][0] == 0);
  mesh.move(std::vector<VertexMove>{{7, 7, {2, 2, 2}, 1}});
  CHECK_FALSE(mesh.changed().empty());
}
