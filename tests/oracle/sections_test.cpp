// Sections of solids beside CGAL's Polygon_mesh_slicer, which walks along the faces of a mesh that a plane crosses.
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <iterator>

#include "oracle/cgal_numbers.h"
#include "strata/io.h"
#include "strata/section.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

namespace strata::oracle {
namespace {

using SurfaceMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;
using Slicer = CGAL::Polygon_mesh_slicer<SurfaceMesh, ExactKernel>;
using Loop = std::vector<planar::RationalPlacement>;

struct NamedSolid {
  std::string name;
  Solid solid;
};

/// Towers on a plate: a section of many loops.
Mesh towers() {
  test::CellGrid grid(9, 9, 3, false);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j)
      for (int k = 0; k < 3; ++k) grid.filled[grid.number(i, j, k)] = k == 0 || (i % 2 == 0 && j % 2 == 0);
  return test::cell_solid(grid);
}

/// Twelve solids, two of them with vertices that are no doubles; larger ones where the corpus is at hand.
std::vector<NamedSolid> solids() {
  std::vector<NamedSolid> list;
  const auto add = [&](const std::string& folder, const char* file) {
    list.push_back({file, Solid(read_mesh(folder + file).mesh)});
  };
  for (const char* file : {"spot.obj", "gear.off", "torus.off", "sphere.off", "bracket.off", "drill.off", "cube.off"})
    add(STRATA_DATA_DIR "/", file);
  list.push_back({"towers", Solid(towers())});
  list.push_back({"cavity", Solid(test::box_with_cavity(2))});
  const Solid ball(test::icosphere({.1, .2, .3}, 1.5, 3)), cubes(test::cube_grid(2));
  list.push_back({"ball", ball});
  list.push_back({"rotated", Solid(test::l_shape()).rotated({1, 2, 3, 4})});
  list.push_back({"difference", (cubes.rotated({5, 1, 2, 1}) - ball).separated()});
  const char* corpus = std::getenv("STRATA_CORPUS");
  if (corpus == nullptr) {
    std::cout << "SKIPPED: sections of solids of the corpus (STRATA_CORPUS is not set)\n";
    return list;
  }
  for (const char* file : {"common-3d-test-models/data/rocker-arm.obj", "common-3d-test-models/data/fandisk.obj",
                           "libigl-tutorial-data/3holes.off", "trimesh/models/featuretype.ply"})
    add(std::string(corpus) + "/meshes/", file);
  return list;
}

std::vector<RationalPoint> positions(const ExactMesh& mesh) {
  std::vector<RationalPoint> points;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) points.push_back(mesh.position(v));
  return points;
}

SurfaceMesh surface_mesh(const ExactMesh& mesh) {
  SurfaceMesh result;
  for (const RationalPoint& p : positions(mesh)) result.add_vertex(to_cgal(p));
  using Index = SurfaceMesh::Vertex_index;
  for (const auto& [a, b, c] : mesh.mesh.triangles)
    REQUIRE(result.add_face(Index(a), Index(b), Index(c)) != SurfaceMesh::null_face());
  return result;
}

Rational product(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Rational area_of(const Loop& loop) {
  Rational twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &p = loop[i], &q = loop[(i + 1) % loop.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return twice / 2;
}

/// Without vertices at which it goes straight on, from its least corner.
Loop corners_of(const Loop& loop) {
  Loop corners;
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const auto &a = loop[(i + n - 1) % n], &b = loop[i], &c = loop[(i + 1) % n];
    if ((b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])) corners.push_back(b);
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// What a plane cuts out of a solid.
struct Contours {
  Rational area = 0;
  std::vector<Loop> loops;  ///< corners, sorted; the solid on the left, seen from in front

  friend bool operator==(const Contours&, const Contours&) = default;
};

Contours contours_of(const planar::Region& region) {
  Contours contours{planar::area(region), planar::canonical_form(region)};
  std::sort(contours.loops.begin(), contours.loops.end());
  return contours;
}

/// A solid in both libraries. Its boundary is a manifold, as CGAL's surface mesh asks for.
class Sliced {
 public:
  explicit Sliced(Solid solid)
      : solid_(std::move(solid)),
        points_(positions(solid_.exact_mesh())),
        mesh_(surface_mesh(solid_.exact_mesh())),
        slicer_(mesh_) {}
  Sliced(const Sliced&) = delete;
  Sliced& operator=(const Sliced&) = delete;

  [[nodiscard]] const Solid& solid() const { return solid_; }
  [[nodiscard]] const std::vector<RationalPoint>& points() const { return points_; }

  /// The heights of all vertices over the origin along a normal: increasing, each once.
  [[nodiscard]] std::vector<Rational> heights(const RationalPoint& normal) const {
    std::vector<Rational> heights;
    for (const RationalPoint& p : points_) heights.push_back(product(normal, p));
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
  }

  /// CGAL's contours. Requires that no vertex is in the plane.
  [[nodiscard]] Contours contours(const Plane& plane) const {
    std::vector<std::vector<ExactKernel::Point_3>> lines;
    const RationalPoint& n = plane.normal;
    slicer_(ExactKernel::Plane_3(to_cgal(n[0]), to_cgal(n[1]), to_cgal(n[2]), to_cgal(-plane.offset)),
            std::back_inserter(lines));
    const PlaneAxes axes = axes_of(plane);
    Contours contours;
    for (const auto& line : lines) {
      REQUIRE(line.front() == line.back());
      Loop loop;
      for (auto p = line.begin() + 1; p != line.end(); ++p) {
        const RationalPoint point = from_cgal(*p);
        loop.push_back({point[axes.u], point[axes.v]});
      }
      contours.area += area_of(loop);
      contours.loops.push_back(corners_of(loop));
    }
    std::sort(contours.loops.begin(), contours.loops.end());
    return contours;
  }

 private:
  Solid solid_;
  std::vector<RationalPoint> points_;
  SurfaceMesh mesh_;
  Slicer slicer_;
};

/// Directions of planes: along the axes, of small integers, and of doubles.
std::vector<RationalPoint> normals(test::Random& random) {
  std::vector<RationalPoint> list{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -2, 0}, {1, 1, 0}, {1, -1, 1}};
  for (int i = 0; i < 2; ++i) list.push_back({random.between(-9, 9), random.between(-9, 9), random.between(1, 9)});
  for (int i = 0; i < 2; ++i) list.push_back({random.unit() - .5, random.unit() - .5, random.unit() - .5});
  return list;
}

/// A height between those of two neighbours among the vertices, so that no vertex is in the plane.
Rational generic_height(const std::vector<Rational>& heights, test::Random& random) {
  const std::size_t i = random.below(heights.size() - 1);
  const Rational part(random.between(1, 6), 7);
  return heights[i] + (heights[i + 1] - heights[i]) * part;
}

struct Counts {
  std::size_t planes = 0, loops = 0, most_loops = 0;

  void add(const Contours& contours) {
    ++planes;
    loops += contours.loops.size();
    most_loops = std::max(most_loops, contours.loops.size());
  }
};

void compare(const Plane& plane, const planar::Region& ours, const Sliced& sliced, Counts& counts) {
  CAPTURE(plane.normal, plane.offset);
  const Contours found = contours_of(ours), expected = sliced.contours(plane);
  REQUIRE(found.area == expected.area);
  REQUIRE(found.loops.size() == expected.loops.size());
  REQUIRE(found == expected);
  counts.add(found);
}

/// The area of sections as the plane comes to its place from in front. Between the heights of vertices it is a
/// polynomial of degree two, which three sections determine.
Rational limit_of_area(const Sliced& sliced, const Plane& plane) {
  const std::vector<Rational> heights = sliced.heights(plane.normal);
  const auto next = std::upper_bound(heights.begin(), heights.end(), plane.offset);
  if (next == heights.end()) return 0;
  const Rational step = (*next - plane.offset) / 4;
  const auto area = [&](int steps) { return sliced.contours({plane.normal, plane.offset + steps * step}).area; };
  return 3 * area(1) - 3 * area(2) + area(3);
}

void compare_limit(const Plane& plane, const planar::Region& ours, const Sliced& sliced, Counts& counts) {
  CAPTURE(plane.normal, plane.offset);
  REQUIRE(planar::area(ours) == limit_of_area(sliced, plane));
  counts.add(contours_of(ours));
}

RationalPoint axis_normal(std::size_t axis) {
  RationalPoint normal{0, 0, 0};
  normal[axis] = 1;
  return normal;
}

void print(const std::string& what, std::size_t solids, const Counts& counts) {
  std::cout << what << " of " << solids << " solids: " << counts.planes << " planes, " << counts.loops
            << " loops, up to " << counts.most_loops << " in one plane, compared with CGAL's Polygon_mesh_slicer\n";
}

/// Tests every solid, with random numbers of its own, and says how much was compared.
template <class Test>
void for_each_solid(const std::string& what, const Test& test) {
  Counts counts;
  const auto list = solids();
  for (const auto& [name, solid] : list) {
    CAPTURE(name);
    const Sliced sliced(solid);
    test::Random random(sliced.points().size());
    test(solid, sliced, random, counts);
  }
  print(what, list.size(), counts);
}

}  // namespace

// Catches: loops turned, joined or lost, crossings on the wrong edges, wrong axes.
TEST_CASE("sections by planes without vertices are CGAL's, loop by loop", "[oracle][section]") {
  for_each_solid("sections", [](const Solid& solid, const Sliced& sliced, test::Random& random, Counts& counts) {
    for (const RationalPoint& normal : normals(random)) {
      const std::vector<Rational> heights = sliced.heights(normal);
      for (int i = 0; i < 3; ++i) {
        const Plane plane(normal, generic_height(heights, random));
        compare(plane, section(solid, plane), sliced, counts);
      }
    }
  });
}

// Catches: the same in `slice`, which has arithmetic of its own, and planes of a stack mixed up.
TEST_CASE("slices between vertices are CGAL's, loop by loop", "[oracle][section]") {
  for_each_solid("slices", [](const Solid& solid, const Sliced& sliced, test::Random& random, Counts& counts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<Rational> heights = sliced.heights(axis_normal(axis));
      std::vector<double> at;
      while (at.size() < 8) {
        const double height = to_nearest_double(generic_height(heights, random));
        if (!std::binary_search(heights.begin(), heights.end(), Rational(height))) at.push_back(height);
      }
      std::sort(at.begin(), at.end());
      const std::vector<planar::Region> regions = slice(solid, axis, at);
      for (std::size_t i = 0; i < at.size(); ++i) compare({axis_normal(axis), at[i]}, regions[i], sliced, counts);
    }
  });
}

// Catches: vertices and faces in the plane taken to be behind it where they are in front, and the reverse.
TEST_CASE("sections by planes through vertices and faces are limits of CGAL's", "[oracle][section]") {
  for_each_solid("sections through vertices",
                 [](const Solid& solid, const Sliced& sliced, test::Random& random, Counts& counts) {
                   const std::vector<RationalPoint>& points = sliced.points();
                   for (const RationalPoint& normal : normals(random)) {
                     const Plane plane(normal, product(normal, random.pick(points)));
                     compare_limit(plane, section(solid, plane), sliced, counts);
                   }
                   for (int i = 0; i < 4; ++i) {
                     const auto& [a, b, c] = random.pick(solid.mesh().triangles);
                     const Plane front = Plane::through(points[a], points[b], points[c]), back = front.opposite();
                     compare_limit(front, section(solid, front), sliced, counts);
                     compare_limit(back, section(solid, back), sliced, counts);
                   }
                 });
}

TEST_CASE("slices through vertices, or beside them by less than an ulp, are limits of CGAL's", "[oracle][section]") {
  for_each_solid("slices through vertices",
                 [](const Solid& solid, const Sliced& sliced, test::Random& random, Counts& counts) {
                   for (std::size_t axis = 0; axis < 3; ++axis) {
                     std::vector<double> at;
                     for (int i = 0; i < 4; ++i) at.push_back(random.pick(solid.mesh().vertices)[axis]);
                     std::sort(at.begin(), at.end());
                     const std::vector<planar::Region> regions = slice(solid, axis, at);
                     for (std::size_t i = 0; i < at.size(); ++i)
                       compare_limit({axis_normal(axis), at[i]}, regions[i], sliced, counts);
                   }
                 });
}

// Of a solid that touches itself CGAL cuts a copy whose sheets are separated; there loops may be joined otherwise.
TEST_CASE("sections of 200 random solids, which may touch themselves, are CGAL's", "[oracle][section]") {
  Counts counts;
  std::size_t touching = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Solid solid(test::lattice_solid(random));
    const Sliced sliced(solid.separated());
    const bool is_manifold = sliced.points().size() == solid.mesh().vertices.size();
    touching += is_manifold ? 0 : 1;
    for (int i = 0; i < 3; ++i) {
      const RationalPoint normal{random.between(-2, 2), random.between(-2, 2), random.between(1, 2)};
      const Plane between(normal, generic_height(sliced.heights(normal), random));
      if (is_manifold)
        compare(between, section(solid, between), sliced, counts);
      else
        REQUIRE(planar::area(section(solid, between)) == sliced.contours(between).area);
      const Plane through(normal, product(normal, random.pick(sliced.points())));
      compare_limit(through, section(solid, through), sliced, counts);
    }
  }
  print("sections", 200, counts);
  std::cout << touching << " of these solids touch themselves\n";
}

}  // namespace strata::oracle
