// decompose_bench MESH...: convex pieces and seconds of ours, from meshes in memory, and of CGAL's
// convex_decomposition_3, from Nef polyhedra in memory; what it takes to make these is told apart.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_decomposition_3.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "strata/convex.h"
#include "strata/io.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Triangles connected over vertices, a list for each part.
std::vector<std::vector<strata::Triangle>> parts_of(const strata::Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[root(a)] = root(b);
    parent[root(b)] = root(c);
  }
  std::map<std::uint32_t, std::vector<strata::Triangle>> parts;
  for (const strata::Triangle& t : mesh.triangles) parts[root(t[0])].push_back(t);
  std::vector<std::vector<strata::Triangle>> result;
  for (auto& [of, triangles] : parts) result.push_back(std::move(triangles));
  return result;
}

/// By the parity of the parts, so that cavities and what is in them need no case.
Nef nef_of(const strata::Mesh& mesh) {
  Nef all;
  for (const std::vector<strata::Triangle>& triangles : parts_of(mesh)) {
    CGAL::Surface_mesh<Kernel::Point_3> surface;
    using Index = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
    std::map<std::uint32_t, Index> at;
    for (const strata::Triangle& t : triangles)
      for (const std::uint32_t v : t)
        if (const auto [known, is_new] = at.try_emplace(v); is_new)
          known->second = surface.add_vertex({mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]});
    for (const auto& [a, b, c] : triangles)
      if (surface.add_face(at[a], at[b], at[c]) == CGAL::Surface_mesh<Kernel::Point_3>::null_face())
        throw std::runtime_error("CGAL refuses a face");
    Nef part(surface);
    if (!CGAL::Polygon_mesh_processing::is_outward_oriented(surface)) part = part.complement();
    all = all ^ part;
  }
  return all;
}

struct Outcome {
  std::size_t pieces = 0;
  double seconds = 0;
  double preparation = 0;  ///< not in `seconds`
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

Outcome theirs(const strata::Solid& solid) {
  Outcome outcome;
  auto start = Clock::now();
  Nef nef = nef_of(solid.mesh());
  outcome.preparation = seconds_since(start);
  start = Clock::now();
  CGAL::convex_decomposition_3(nef);
  outcome.seconds = seconds_since(start);
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
  std::printf("| mesh | triangles | reflex edges | pieces | CGAL's | s | CGAL's | times faster | CGAL's Nef, s |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    try {
      const strata::Solid solid(strata::read_mesh(file).mesh);
      const std::size_t reflex = strata::convex::decompose(solid).reflex_edges;
      const Outcome a = ours(solid, runs);
      std::printf("| %s | %zu | %zu | %zu |", file.substr(file.rfind('/') + 1).c_str(), solid.mesh().triangles.size(),
                  reflex, a.pieces);
      std::fflush(stdout);
      const Outcome b = without_cgal ? Outcome{} : theirs(solid);
      std::printf(" %zu | %.4f | %.3f | %.0f | %.3f |\n", b.pieces, a.seconds, b.seconds, b.seconds / a.seconds,
                  b.preparation);
    } catch (const std::exception& e) {
      std::printf("%s: %s\n", file.c_str(), e.what());
    }
    std::fflush(stdout);
  }
}
