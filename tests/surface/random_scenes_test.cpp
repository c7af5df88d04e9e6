// Random scenes of triangles and boxes on a small grid, where faces touch, overlap and cross in every way, against the
// minimal complex of their union (complex.h): other code, checked against Nef polyhedra in tests/oracle.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "strata/check.h"
#include "strata/complex.h"
#include "strata/surface.h"
#include "support/shapes.h"

using namespace strata;

namespace {

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed), size_(2 + static_cast<int>(seed % 4)) {}

  std::vector<Surface> make() {
    std::vector<Surface> surfaces;
    for (int k = number(1, 4); k > 0; --k) surfaces.push_back(number(0, 2) == 0 ? Surface(box()) : triangles());
    return surfaces;
  }
  Solid box() {
    const Vertex a = point();
    Vertex b = point();
    for (std::size_t i = 0; i < 3; ++i)
      if (b[i] <= a[i]) b[i] = a[i] + number(1, size_);
    return Solid(test::box(a, b));
  }
  Surface triangles() {
    Mesh mesh;
    for (int n = number(1, 7); n > 0; --n) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (int i = 0; i < 3; ++i) mesh.vertices.push_back(point());
      if (number(0, 2) == 0 && first >= 3) mesh.vertices[first] = mesh.vertices[first - 1];
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return Surface(mesh);
  }
  int number(int least, int most) { return std::uniform_int_distribution<>(least, most)(random_); }

 private:
  Vertex point() {
    return {static_cast<double>(number(0, size_)), static_cast<double>(number(0, size_)),
            static_cast<double>(number(0, size_))};
  }

  std::mt19937 random_;
  int size_;
};

complex::SelectiveComplex complex_of(const std::vector<Surface>& surfaces) {
  complex::Simplices simplices;
  for (const Surface& s : surfaces) {
    const auto shift = static_cast<std::uint32_t>(simplices.vertices.size());
    simplices.vertices.insert(simplices.vertices.end(), s.mesh().vertices.begin(), s.mesh().vertices.end());
    for (const auto& [a, b, c] : s.mesh().triangles) simplices.triangles.push_back({a + shift, b + shift, c + shift});
  }
  return complex::unite_closed(simplices);
}

std::vector<Rational> volumes(const std::vector<Solid>& solids) {
  std::vector<Rational> list;
  for (const Solid& s : solids) list.push_back(s.volume());
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Rational> volumes(const complex::SelectiveComplex& c) {
  std::vector<Rational> list;
  for (std::uint32_t v = 0; v < c.count(3); ++v)
    if (const auto volume = complex::volume_of_cell(c, v)) list.push_back(*volume);
  std::sort(list.begin(), list.end());
  return list;
}

Rational total(const std::vector<Solid>& solids) {
  Rational sum = 0;
  for (const Solid& s : solids) sum += s.volume();
  return sum;
}

/// Twice the area of the walls, squared per wall, so that it is exact: no wall is lost, doubled or without area.
bool have_area(const ExactMesh& mesh) {
  return std::none_of(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end(), [&](const Triangle& t) {
    return Plane::through(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])).normal ==
           RationalPoint{0, 0, 0};
  });
}

}  // namespace

TEST_CASE("cells of random scenes are the volumes of their complex", "[surface]") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    const std::vector<Surface> surfaces = RandomScene(seed).make();
    const Arrangement a = arrange(surfaces);
    const std::vector<Solid> solids = a.solids();
    REQUIRE(have_area(a.mesh));
    const complex::SelectiveComplex c = complex_of(surfaces);
    REQUIRE(a.cell_count == std::max(1U, c.count(3)));
    REQUIRE(volumes(solids) == volumes(c));
    for (const Solid& s : solids) {
      REQUIRE(check(s.exact_mesh()).empty());
      REQUIRE(s.components().size() == 1);
    }
    // Walls meet in whole edges and vertices: arranged again, nothing is divided.
    const Arrangement again = arrange(std::vector{Surface(a.mesh)});
    REQUIRE(again.mesh.mesh.triangles.size() == a.mesh.mesh.triangles.size());
    REQUIRE(again.covers.empty());
    REQUIRE(again.cell_count == a.cell_count);
  }
}

TEST_CASE("points of random scenes are in the same cells as in the complex", "[surface]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    RandomScene scene(seed);
    const std::vector<Surface> surfaces = scene.make();
    const Arrangement a = arrange(surfaces);
    std::vector<complex::SelectiveComplex> solids;
    for (const Solid& s : a.solids()) solids.push_back(complex::of_solid(s, complex::Border::open));
    const complex::SelectiveComplex c = complex_of(surfaces);
    std::vector<std::uint32_t> cell_of(c.count(3), complex::none);
    for (int i = 0; i < 12; ++i) {
      const auto coordinate = [&] { return Rational(scene.number(-1, 41), 8); };
      const RationalPoint p{coordinate(), coordinate(), coordinate()};
      const complex::Cell at = complex::locate(c, p);
      std::uint32_t cell = 0;
      for (std::uint32_t k = 0; k < solids.size(); ++k)
        if (complex::contains(solids[k], p)) cell = k + 1;
      if (at.dimension < 3) continue;  // on a wall, which may be inside a cell
      if (cell_of[at.index] == complex::none) cell_of[at.index] = cell;
      REQUIRE(cell_of[at.index] == cell);
      REQUIRE((cell == 0) == (at.index == 0));
    }
  }
}

TEST_CASE("laws of split and clip in random scenes", "[surface]") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    RandomScene scene(seed);
    const Solid solid = scene.box() | scene.box();
    const std::vector<Surface> surfaces = scene.make();
    const std::vector<Solid> pieces = split(solid, surfaces);
    REQUIRE(total(pieces) == solid.volume());
    REQUIRE(union_(pieces) == solid);
    for (const Solid& piece : pieces) REQUIRE(check(piece.exact_mesh()).empty());

    const Surface& surface = surfaces.front();
    const double whole = imprint(std::vector{surface}).front().area();
    double sum = 0;
    for (const ClipTo part : all_clips) {
      const Surface kept = clip(surface, solid, part);
      sum += kept.area();
      for (const ClipTo other : all_clips)
        REQUIRE(clip(kept, solid, other).area() == (part == other ? Approx(kept.area()) : Approx(0)));
    }
    REQUIRE(sum == Approx(whole).epsilon(1e-12));
  }
}
