// complex_bench [FILE...]: operators of complexes beside CGAL's Nef_polyhedron_3, on solids in files. Minimum of the
// runs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "oracle/nef_complex.h"
#include "strata/complex.h"
#include "strata/io.h"

namespace {

using strata::complex::SelectiveComplex;
using Nef = strata::oracle::NefComplex<3>;

double best_of(int runs, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void compare(const char* what, int runs, const std::function<void()>& ours, const std::function<void()>& theirs) {
  const double a = best_of(3 * runs, ours), b = best_of(runs, theirs);
  std::printf("  %-22s strata %10.6f s   Nef_3 %10.6f s   ratio %8.1f\n", what, a, b, b / a);
  std::fflush(stdout);
}

void run(const std::string& path, int runs) {
  const strata::Mesh mesh = strata::read_mesh(path).mesh;
  const strata::Solid solid(mesh);
  strata::Mesh moved = solid.mesh();
  const auto box = solid.bounding_box();
  for (strata::Vertex& p : moved.vertices)
    for (std::size_t i = 0; i < 3; ++i) p[i] += (box.upper[i] - box.lower[i]) / 3.0;
  const SelectiveComplex s = strata::complex::of_solid(solid);
  const Nef n = Nef::solid(solid.mesh());
  std::printf("%s: %zu triangles; cells %u %u %u %u\n", path.c_str(), solid.mesh().triangles.size(), s.count(0),
              s.count(1), s.count(2), s.count(3));
  compare(
      "from the solid", runs, [&] { (void)strata::complex::of_solid(solid); }, [&] { (void)Nef::solid(solid.mesh()); });
  compare(
      "interior", runs, [&] { (void)interior(s); }, [&] { (void)n.interior(); });
  compare(
      "simplify, interior", runs,  // with incidences that are not known yet
      [&] { (void)interior(SelectiveComplex::of(s.cells())); }, [&] { (void)n.interior(); });
  compare(
      "closure", runs, [&] { (void)closure(s); }, [&] { (void)n.closure(); });
  compare(
      "boundary", runs, [&] { (void)boundary(s); }, [&] { (void)n.boundary(); });
  compare(
      "regularization", runs, [&] { (void)regularized(s); }, [&] { (void)n.regularization(); });
  compare(
      "complement", runs, [&] { (void)~s; }, [&] { (void)n.complement(); });
  const SelectiveComplex t = strata::complex::of_solid(strata::Solid(moved), strata::complex::Border::open);
  const Nef m = Nef::solid(moved).interior();
  compare(
      "closed | open", runs, [&] { (void)(s | t); }, [&] { (void)n.unite(m); });
  compare(
      "closed - open", runs, [&] { (void)(s - t); }, [&] { (void)n.subtract(m); });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Operators of complexes beside CGAL's");
  std::vector<std::string> files;
  int runs = 3;
  app.add_option("FILE", files, "Closed meshes")->required();
  app.add_option("--runs", runs, "How often CGAL runs; we run three times as often");
  CLI11_PARSE(app, argc, argv);
  for (const std::string& f : files) run(f, runs);
  return 0;
}
