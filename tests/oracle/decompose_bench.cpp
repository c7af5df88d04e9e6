// decompose_bench MESH...: convex pieces and seconds of ours and of CGAL's convex_decomposition_3, from meshes in memory.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_decomposition_3.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "strata/convex/decompose.h"
#include "strata/io/mesh_file.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Nef nef_of(const strata::Mesh& mesh) {
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  using Index = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
  for (const auto& [x, y, z] : mesh.vertices) surface.add_vertex({x, y, z});
  for (const auto& [a, b, c] : mesh.triangles) surface.add_face(Index(a), Index(b), Index(c));
  return Nef(surface);
}

struct Outcome {
  std::size_t pieces = 0;
  double seconds = 0;
};

Outcome ours(const strata::Solid& solid, int runs) {
  std::vector<double> times;
  Outcome outcome;
  for (int i = 0; i < runs; ++i) {
    const auto start = Clock::now();
    outcome.pieces = strata::convex::decompose(solid).pieces.size();
    times.push_back(seconds_since(start));
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  outcome.seconds = times[static_cast<std::size_t>(runs / 2)];
  return outcome;
}

/// Making the Nef polyhedron is not counted.
Outcome theirs(const strata::Solid& solid) {
  Nef nef = nef_of(solid.mesh());
  const auto start = Clock::now();
  CGAL::convex_decomposition_3(nef);
  Outcome outcome{0, seconds_since(start)};
  auto volume = ++nef.volumes_begin();
  for (; volume != nef.volumes_end(); ++volume) outcome.pieces += volume->mark() ? 1 : 0;
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Convex pieces of meshes, ours and CGAL's");
  std::vector<std::string> files;
  int runs = 5;
  bool without_cgal = false;
  app.add_option("MESH", files)->required();
  app.add_option("--runs", runs, "Of ours; the median is told");
  app.add_flag("--without-cgal", without_cgal);
  CLI11_PARSE(app, argc, argv);
  std::printf("| mesh | triangles | reflex edges | pieces | CGAL's | s | CGAL's | times faster |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    try {
      const strata::Solid solid(strata::read_mesh(file).mesh);
      const std::size_t reflex = strata::convex::decompose(solid).reflex_edges;
      const Outcome a = ours(solid, runs);
      std::printf("| %s | %zu | %zu | %zu |", file.substr(file.rfind('/') + 1).c_str(), solid.mesh().triangles.size(), reflex,
                  a.pieces);
      std::fflush(stdout);
      const Outcome b = without_cgal ? Outcome{} : theirs(solid);
      std::printf(" %zu | %.4f | %.3f | %.0f |\n", b.pieces, a.seconds, b.seconds, b.seconds / a.seconds);
    } catch (const std::exception& e) {
      std::printf("%s: %s\n", file.c_str(), e.what());
    }
    std::fflush(stdout);
  }
}
