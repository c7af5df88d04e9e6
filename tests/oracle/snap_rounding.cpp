// CGAL's iterative snap rounding (6.1 and later) of all triangles of binary PLY files together, as snap_rounding.py
// calls it: prints JSON. Debian 12 has an older CGAL, so this is built by hand, with the headers of a newer one:
//
//   g++ -std=c++17 -O3 -DNDEBUG -I CGAL/include -I lib -I include snap_rounding.cpp -o snap_rounding -lgmp -lmpfr -ltbb
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/autorefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <array>
#include <chrono>
#include <fstream>
#include <iostream>
#include <set>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Triangle = std::array<std::size_t, 3>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// The corners from the least one on.
static std::array<Point, 3> corners(const std::vector<Point>& points, const Triangle& t) {
  std::array<Point, 3> c{points[t[0]], points[t[1]], points[t[2]]};
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

int main(int argc, char** argv) {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (int i = 1; i < argc; ++i) {
    std::vector<Point> more;
    std::vector<Triangle> faces;
    std::ifstream file(argv[i], std::ios::binary);
    if (!CGAL::IO::read_PLY(file, more, faces)) return 1;
    for (const Triangle& t : faces)
      triangles.push_back({t[0] + points.size(), t[1] + points.size(), t[2] + points.size()});
    points.insert(points.end(), more.begin(), more.end());
  }
  std::set<std::array<Point, 3>> given;
  for (const Triangle& t : triangles) given.insert(corners(points, t));
  const auto start = std::chrono::steady_clock::now();
  const bool is_free = pmp::autorefine_triangle_soup(
      points, triangles,
      CGAL::parameters::apply_iterative_snap_rounding(true).concurrency_tag(CGAL::Parallel_if_available_tag()));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::size_t untouched = 0;
  for (const Triangle& t : triangles) untouched += given.count(corners(points, t));
  std::cout << "{\"seconds\": " << seconds.count() << ", \"free\": " << is_free
            << ", \"triangles\": " << triangles.size() << ", \"untouched\": " << untouched << ", \"crosses\": "
            << pmp::does_triangle_soup_self_intersect<CGAL::Parallel_if_available_tag>(points, triangles) << "}\n";
}
