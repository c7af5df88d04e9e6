#include "core/io/triangulate.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "core/io/planar_polygon.h"
#include "core/kernel/predicates.h"

using namespace strata;

namespace {

struct Result {
  io::PolygonShape shape;
  std::vector<Triangle> triangles;
};

Result divide(const std::vector<Vertex>& loop) {
  Result r;
  r.triangles.resize(loop.size() - 2);
  r.shape = io::triangulate(loop, r.triangles);
  return r;
}

std::vector<Vertex> flat(const std::vector<PlanePoint>& points) {
  std::vector<Vertex> loop;
  for (const auto& p : points) loop.push_back({p[0], p[1], 0});
  return loop;
}

/// Directed sides that do not cancel: those of the polygon, each once, if nothing was lost.
bool has_the_sides_of_the_polygon(const Result& r, std::size_t n) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  const auto add = [&](std::uint32_t a, std::uint32_t b, int k) {
    if (a < b)
      sides[{a, b}] += k;
    else
      sides[{b, a}] -= k;
  };
  for (const auto& t : r.triangles)
    for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
  for (std::uint32_t i = 0; i < n; ++i) add(i, static_cast<std::uint32_t>((i + 1) % n), -1);
  return std::all_of(sides.begin(), sides.end(), [](const auto& s) { return s.second == 0; });
}

/// With the sides of the polygon, positive triangles only cover it exactly.
bool all_turn_left(const Result& r, const std::vector<Vertex>& loop) {
  return std::all_of(r.triangles.begin(), r.triangles.end(), [&](const Triangle& t) {
    const auto at = [&](std::size_t k) { return PlanePoint{loop[t[k]][0], loop[t[k]][1]}; };
    return orient2d(at(0), at(1), at(2)) == Sign::positive;
  });
}

void check_exact(const std::vector<PlanePoint>& points) {
  auto loop = flat(points);
  for (std::size_t start = 0; start < std::min<std::size_t>(loop.size(), 40); ++start) {
    const auto r = divide(loop);
    CHECK(r.shape.planar);
    CHECK(r.shape.simple);
    CHECK(has_the_sides_of_the_polygon(r, loop.size()));
    CHECK(all_turn_left(r, loop));
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
}

}  // namespace

TEST_CASE("Convex and concave polygons are divided exactly", "[io][polygon]") {
  check_exact({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  check_exact({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}});                // reflex quadrilateral
  check_exact({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});  // L
  check_exact({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}});
}

TEST_CASE("Collinear corners are kept, and no triangle is degenerate", "[io][polygon]") {
  check_exact({{0, 0}, {1, 0}, {2, 0}, {0, 2}});
  check_exact({{0, 0}, {1, 0}, {2, 0}, {1, 1}, {0, 2}, {0, 1}});
  check_exact({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}});
}

TEST_CASE("Polygons that meet themselves in corners and along whole sides are divided exactly", "[io][polygon]") {
  check_exact({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST_CASE("Differences far below rounding decide", "[io][polygon]") {
  const double up = std::nextafter(1.0, 2.0), down = std::nextafter(1.0, 0.0);
  check_exact({{0, 0}, {1, down}, {2, 2}, {0, 2}});
  check_exact({{0, 0}, {1e-300, 0}, {1e300, 1e300}, {0, 1e-300}});
  CHECK(orient2d({0, 0}, {1, up}, {2, 2}) == Sign::negative);
  CHECK(orient2d({0, 0}, {5e-324, 5e-324}, {1e308, 1e308}) == Sign::zero);
  CHECK(orient2d({0, 0}, {5e-324, 5e-324}, {1e308, std::nextafter(1e308, 0)}) == Sign::negative);
  CHECK(orient2d({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}) == Sign::zero);
}

TEST_CASE("Polygons in any plane keep their orientation", "[io][polygon]") {
  const std::vector<PlanePoint> shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const bool reversed : {false, true})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<Vertex> loop;
      for (const auto& p : shape) {
        Vertex q{};
        q[axis] = p[0];
        q[(axis + 1) % 3] = p[1];
        q[(axis + 2) % 3] = p[0] + 2 * p[1];
        loop.push_back(q);
      }
      if (reversed) std::reverse(loop.begin(), loop.end());
      const auto r = divide(loop);
      CHECK(r.shape.planar);
      CHECK(r.shape.simple);
      CHECK(has_the_sides_of_the_polygon(r, loop.size()));
    }
}

TEST_CASE("Planarity is decided exactly", "[io][polygon]") {
  CHECK(io::is_planar(std::vector<Vertex>{{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}}));
  CHECK_FALSE(io::is_planar(std::vector<Vertex>{{0, 0, 0}, {1, 0, 1}, {1, 1, std::nextafter(2, 3)}, {0, 1, 1}}));
  CHECK_FALSE(io::is_planar(std::vector<Vertex>{{0, 0, 0}, {1e200, 0, 0}, {1, 1, 5e-324}, {0, 1e-200, 0}}));
  CHECK(io::is_planar(std::vector<Vertex>{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 4}}));
}

TEST_CASE("The sign of a polygon's area is exact", "[io][polygon]") {
  const std::vector<PlanePoint> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(area_sign(square) == Sign::positive);
  CHECK(area_sign(std::vector(square.rbegin(), square.rend())) == Sign::negative);
  CHECK(area_sign(std::vector<PlanePoint>{{0, 0}, {4, 4}, {4, 0}, {0, 4}}) == Sign::zero);  // a bow
  CHECK(area_sign(std::vector<PlanePoint>{{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}}) == Sign::zero);
  // Two triangles of opposite sense, one larger by a unit in the last place, at three scales.
  for (const double scale : {1.0, 1e-310, 1e300})
    for (const bool above : {false, true}) {
      const double tip = std::nextafter(scale, above ? 2 * scale : 0);
      const std::vector<PlanePoint> bow{{0, 0}, {scale, scale},  {scale, -scale},
                                        {0, 0}, {-scale, scale}, {-scale, -tip}};
      CHECK(area_sign(bow) == (above ? Sign::positive : Sign::negative));
    }
  CHECK(area_sign(std::vector<PlanePoint>{{-1e308, -1e308}, {1e308, -1e308}, {1e308, 1e308}}) == Sign::positive);
  CHECK(area_sign(square) != area_sign(std::vector<PlanePoint>{{0, 0}, {5e-324, 5e-324}}));
}

TEST_CASE("Polygons that are not planar or not simple are divided all the same", "[io][polygon]") {
  const std::vector<Vertex> saddle{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  const std::vector<Vertex> bow = flat({{0, 0}, {4, 4}, {4, 0}, {0, 3}});
  const std::vector<Vertex> spike = flat({{0, 0}, {2, 0}, {4, 0}, {2, 0}, {2, 2}});
  const std::vector<Vertex> touching = flat({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});  // a corner inside a side
  const std::vector<Vertex> line = flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  CHECK_FALSE(divide(saddle).shape.planar);
  CHECK(divide(saddle).shape.simple);
  CHECK_FALSE(divide(bow).shape.simple);
  CHECK_FALSE(divide(spike).shape.simple);
  CHECK_FALSE(divide(line).shape.simple);
  CHECK_FALSE(divide(touching).shape.simple);
  for (const auto& loop : {saddle, bow, spike, touching, line})
    CHECK(has_the_sides_of_the_polygon(divide(loop), loop.size()));
}

TEST_CASE("Star-shaped polygons of small integers are divided exactly", "[io][polygon][property]") {
  const auto seed = GENERATE(range(0u, 300u));
  CAPTURE(seed);
  std::mt19937 random(seed);
  // One point per direction, in the order of directions around the origin: simple, with many collinear corners.
  std::map<double, PlanePoint> by_direction;
  for (int i = 0; i < 40; ++i) {
    const double x = static_cast<double>(random() % 13) - 6, y = static_cast<double>(random() % 13) - 6;
    if (x != 0 || y != 0) by_direction.emplace(std::atan2(y, x), PlanePoint{x, y});
  }
  std::vector<PlanePoint> points{{7, 0}};
  for (const auto& [direction, p] : by_direction)
    if (direction > 0 && direction < 3) points.push_back(p);
  points.push_back({-7, 0});
  points.push_back({0, -7});
  check_exact(points);
}

TEST_CASE("Large polygons take little time", "[io][polygon]") {
  // A comb and a spiral: thousands of reflex corners, few ears at a time.
  std::vector<PlanePoint> comb{{0, -1}};
  for (int i = 0; i < 5000; ++i) {
    comb.push_back({2.0 * i + 1, -1});
    comb.push_back({2.0 * i + 1, 1000});
  }
  std::reverse(comb.begin() + 1, comb.end());
  std::reverse(comb.begin(), comb.end());
  const auto loop = flat(comb);
  const auto r = divide(loop);
  CHECK(r.triangles.size() == loop.size() - 2);

  std::vector<PlanePoint> spiral;
  constexpr int n = 5000;
  for (int i = 0; i < n; ++i) spiral.push_back({(1.0 + i) * std::cos(i * 0.1), (1.0 + i) * std::sin(i * 0.1)});
  for (int i = n; i-- > 0;) spiral.push_back({(0.5 + i) * std::cos(i * 0.1), (0.5 + i) * std::sin(i * 0.1)});
  const auto s = divide(flat(spiral));
  CHECK(s.shape.simple);
  CHECK(has_the_sides_of_the_polygon(s, spiral.size()));
}
