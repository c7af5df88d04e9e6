// combine_bench A B: the union of two solids from layer decompositions about one origin, beside CGAL's Nef polyhedra.
// Both start with their own structures made; both results are compared exactly.
#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "oracle/nef.h"
#include "strata/io.h"
#include "strata/query.h"

namespace {

using strata::oracle::NefSolid;

template <class Work>
auto timed(const char* what, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%-24s %10.4f s\n", what, seconds.count());
  return result;
}

void run(const std::string& first, const std::string& second) {
  const std::array<strata::Solid, 2> solids{strata::Solid(strata::read_mesh(first).mesh),
                                            strata::Solid(strata::read_mesh(second).mesh)};
  const strata::Origin origin = strata::choose_origin(strata::scene_of(solids));
  const auto layers = timed("strata, decompositions", [&] {
    return std::array{strata::LayerDecomposition(strata::scene_of({&solids[0], 1}), origin),
                      strata::LayerDecomposition(strata::scene_of({&solids[1], 1}), origin)};
  });
  const auto nef = timed("nef, polyhedra", [&] {
    return std::array{NefSolid(solids[0].exact_mesh()), NefSolid(solids[1].exact_mesh())};
  });
  const auto combine = [&] { return strata::combine(layers[0], layers[1], strata::Operation::union_); };
  (void)combine();
  const auto ours = timed("strata, combination", combine);
  const auto theirs =
      timed("nef, combination", [&] { return strata::oracle::nef_combine(strata::Operation::union_, nef); });
  const bool same = strata::Solid(ours.scene().solid(0)).canonical() == strata::canonical_form(theirs.facets());
  std::printf("%u and %u triangles, union of %u: the same as point sets: %s\n", layers[0].scene().face_count(),
              layers[1].scene().face_count(), ours.scene().face_count(), same ? "yes" : "NO");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Combination about one origin beside CGAL's Nef polyhedra", "combine_bench");
  std::string first, second;
  app.add_option("A", first, "A closed mesh")->required();
  app.add_option("B", second, "Another")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    run(first, second);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
