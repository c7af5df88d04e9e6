// assembly_bench: 1,000 parts of about 5,000 triangles at once, arrays in, pairs out; beside CGAL's
// Polygon_mesh_processing::do_intersect on the same pairs of boxes if asked for. Scenes: cubes (a grid in contact
// everywhere), turned (the same, not along the axes), bricks (shifted: triangles of neighbours do not match), narrow
// (interfering with all neighbours), balls (of different sizes, at random), pegs (each in a notch of the next one).
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "core/containers/box_sweep.h"
#include "strata/contact.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transform.h"

namespace {

using strata::Mesh;
using strata::Solid;
using strata::Vertex;

struct Request {
  std::string scene = "cubes";
  int side = 10;  ///< parts along each axis
  int cuts = 20;  ///< squares along each side of a cube
  int runs = 3;
  bool regions = false;  ///< of all contacts
  bool distances = false;
  bool cgal = false;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A matrix of integers whose rows are orthogonal and equally long.
Mesh turned(Mesh mesh) {
  for (Vertex& v : mesh.vertices)
    v = {2 * v[0] - v[1] + 2 * v[2], 2 * v[0] + 2 * v[1] - v[2], -v[0] + 2 * v[1] + 2 * v[2]};
  return mesh;
}

/// A cube of n^3 cells with a peg of a third of its width on one side and a notch for it on the opposite one.
Mesh peg_cube(int n) {
  strata::test::CellGrid grid(n + 2, n, n, false);
  for (int i = 0; i < n + 2; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const bool middle = 3 * j >= n && 3 * j < 2 * n && 3 * k >= n && 3 * k < 2 * n;
        grid.filled[grid.number(i, j, k)] = i < 2 ? !middle : i < n || middle;
      }
  return strata::test::cell_solid(grid);
}

std::vector<Mesh> make_scene(const Request& r) {
  std::vector<Mesh> meshes;
  strata::test::Random random(1);
  const int n = r.cuts;
  const Mesh cube = r.scene == "pegs" ? peg_cube(n) : strata::test::cube_grid(n);
  const double step = r.scene == "narrow" ? n - 0.75 : n;
  const Mesh ball = strata::test::icosphere({0, 0, 0}, 1, 4);
  for (int i = 0; i < r.side; ++i)
    for (int j = 0; j < r.side; ++j)
      for (int k = 0; k < r.side; ++k) {
        if (r.scene == "balls") {
          const double size = 0.4 + 0.2 * random.unit();
          Mesh mesh = ball;
          for (Vertex& v : mesh.vertices) v = {i + size * v[0], j + size * v[1], k + size * v[2]};
          meshes.push_back(std::move(mesh));
          continue;
        }
        const double shift = r.scene == "bricks" ? 0.5 * n * (j % 2) + 0.3125 : 0;
        Mesh mesh = strata::test::translated(cube, {step * i + shift, step * j, step * k + (shift > 1 ? 0.75 : 0)});
        meshes.push_back(r.scene == "turned" ? turned(std::move(mesh)) : std::move(mesh));
      }
  return meshes;
}

std::vector<Solid> solids_of(std::vector<Mesh> meshes) {
  std::vector<Solid> solids;
  for (Mesh& m : meshes) solids.emplace_back(std::move(m));
  return solids;
}

void run_ours(const Request& r, const std::vector<Mesh>& meshes) {
  double best = 1e9, best_prepare = 1e9, best_processor = 1e9;
  std::vector<strata::contact::RelatedPair> pairs;
  for (int n = 0; n < r.runs; ++n) {
    std::vector<Mesh> copy = meshes;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const std::vector<Solid> solids = solids_of(std::move(copy));
    const double prepare = seconds_since(start);
    pairs = strata::contact::Assembly(solids).pairs();
    best = std::min(best, seconds_since(start));
    best_processor = std::min(best_processor, static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
    best_prepare = std::min(best_prepare, prepare);
  }
  std::map<std::string, int> seen;
  for (const auto& pair : pairs) ++seen[name(pair.relation)];
  std::printf("strata  %.3f s, of processors %.3f s (checking the parts %.3f s)", best, best_processor, best_prepare);
  for (const auto& [what, count] : seen) std::printf("  %s %d", what.c_str(), count);
  std::printf("\n");
  if (!r.regions) return;
  const std::vector<Solid> solids = solids_of(meshes);
  const strata::contact::Assembly assembly(solids);
  const auto start = std::chrono::steady_clock::now();
  std::size_t facets = 0, edges = 0, vertices = 0;
  double area = 0;
  for (const auto& pair : pairs) {
    if (pair.relation != strata::contact::Relation::contact) continue;
    const auto region = assembly.contact_region(pair.a, pair.b);
    facets += region.facets.size();
    edges += region.edges.size();
    vertices += region.vertices.size();
    area += region.area();
  }
  std::printf("regions %.3f s on one thread: %zu facets, %zu edges, %zu vertices, area %.17g\n", seconds_since(start),
              facets, edges, vertices, area);
}

void run_distances(const std::vector<Mesh>& meshes) {
  const std::vector<Solid> solids = solids_of(meshes);
  const strata::contact::Assembly assembly(solids);
  const auto start = std::chrono::steady_clock::now();
  std::size_t count = 0;
  for (std::uint32_t b = 1; b < std::min<std::uint32_t>(assembly.size(), 200); ++b)
    if (assembly.relation(0, b) == strata::contact::Relation::apart) {
      (void)assembly.nearest(0, b);
      ++count;
    }
  std::printf("distances of the first part from %zu others: %.3f s\n", count, seconds_since(start));
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Pairs whose closed sets meet; CGAL does not tell contact from interference.
void run_cgal(const std::vector<Mesh>& meshes) {
  std::vector<Surface> surfaces;
  std::vector<strata::Box> boxes;
  for (const Mesh& m : meshes) {
    Surface& s = surfaces.emplace_back();
    strata::Box& box = boxes.emplace_back();
    for (const Vertex& v : m.vertices) {
      s.add_vertex({v[0], v[1], v[2]});
      box.include(v);
    }
    for (const auto& t : m.triangles)
      s.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]), Surface::Vertex_index(t[2]));
  }
  const auto start = std::chrono::steady_clock::now();
  int meeting = 0;
  for (const auto& [a, b] : strata::overlapping_pairs(boxes))
    meeting += CGAL::Polygon_mesh_processing::do_intersect(surfaces[a], surfaces[b],
                                                           CGAL::parameters::do_overlap_test_of_bounded_sides(true));
  std::printf("cgal    %.3f s on one thread: %d pairs meet\n", seconds_since(start), meeting);
}

}  // namespace

int main(int argc, char** argv) {
  Request r;
  CLI::App app;
  app.add_option("--scene", r.scene);
  app.add_option("--side", r.side);
  app.add_option("--cuts", r.cuts);
  app.add_option("--runs", r.runs);
  app.add_flag("--regions", r.regions);
  app.add_flag("--distances", r.distances);
  app.add_flag("--cgal", r.cgal);
  CLI11_PARSE(app, argc, argv);
  const std::vector<Mesh> meshes = make_scene(r);
  std::size_t faces = 0;
  for (const Mesh& m : meshes) faces += m.triangles.size();
  std::printf("%s: %zu parts, %zu triangles\n", r.scene.c_str(), meshes.size(), faces);
  run_ours(r, meshes);
  if (r.distances) run_distances(meshes);
  if (r.cgal) run_cgal(meshes);
}
