// hull_bench [--points N] [--threads N]: convex hulls of random points, Strata beside CGAL's convex_hull_3 (EPICK), on
// the same points, medians of five. Vertices are counted: they agree.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "strata/convex.h"
#include "support/random.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using strata::Vertex;

template <class Work>
double median_of_five(const Work& work) {
  std::array<double, 5> seconds;
  for (double& s : seconds) {
    const auto start = std::chrono::steady_clock::now();
    work();
    s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[2];
}

using Shape = std::vector<Vertex> (*)(std::size_t, strata::test::Random&);

Vertex in_cube(strata::test::Random& random) {
  return {2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
}

double squared_length(const Vertex& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

std::vector<Vertex> cube(std::size_t count, strata::test::Random& random) {
  std::vector<Vertex> points(count);
  for (Vertex& p : points) p = in_cube(random);
  return points;
}

std::vector<Vertex> ball(std::size_t count, strata::test::Random& random) {
  std::vector<Vertex> points(count);
  for (Vertex& p : points) do {
      p = in_cube(random);
    } while (squared_length(p) > 1);
  return points;
}

std::vector<Vertex> sphere(std::size_t count, strata::test::Random& random) {
  std::vector<Vertex> points(count);
  for (Vertex& p : points) {
    do {
      p = in_cube(random);
    } while (squared_length(p) > 1 || squared_length(p) < 0.01);
    const double length = std::sqrt(squared_length(p));
    for (double& x : p) x /= length;
  }
  return points;
}

/// The points of a cube of steps 1: most of the surface is coplanar.
std::vector<Vertex> grid(std::size_t count, strata::test::Random&) {
  const int side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  std::vector<Vertex> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) points.push_back({x * 1.0, y * 1.0, z * 1.0});
  return points;
}

/// The same in steps of 0.1: nearly coplanar.
std::vector<Vertex> tenths(std::size_t count, strata::test::Random& random) {
  std::vector<Vertex> points = grid(count, random);
  for (Vertex& p : points)
    for (double& x : p) x *= 0.1;
  return points;
}

void compare(const char* name, Shape shape, std::size_t count, unsigned threads) {
  strata::test::Random random(1);
  const std::vector<Vertex> points = shape(count, random);
  std::vector<Kernel::Point_3> theirs;
  for (const auto& [x, y, z] : points) theirs.emplace_back(x, y, z);
  std::size_t vertices = 0, facets = 0, corners = 0;
  const double strata = median_of_five([&] {
    const auto hull = strata::convex::convex_hull(points, threads);
    vertices = hull.vertices.size();
    facets = hull.facets.size();
  });
  const double cgal = median_of_five([&] {
    Surface surface;
    CGAL::convex_hull_3(theirs.begin(), theirs.end(), surface);
    corners = surface.number_of_vertices();
  });
  std::printf("%-8s %9zu points  strata %8.4f s (%zu vertices, %zu facets)  cgal %8.4f s (%zu vertices)  ratio %.2f\n",
              name, points.size(), strata, vertices, facets, cgal, corners, cgal / strata);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Convex hulls beside CGAL's", "hull_bench");
  std::size_t count = 1'000'000;
  unsigned threads = 0;
  std::string only;
  app.add_option("--points", count, "How many points");
  app.add_option("--threads", threads, "Ours; 0: all cores. CGAL's has one");
  app.add_option("--only", only, "One shape: cube, ball, sphere, grid or tenths");
  CLI11_PARSE(app, argc, argv);
  for (const auto& [name, shape] : {std::pair<const char*, Shape>{"cube", cube},
                                    {"ball", ball},
                                    {"sphere", sphere},
                                    {"grid", grid},
                                    {"tenths", tenths}})
    if (only.empty() || only == name) compare(name, shape, count, threads);
}
