// The same by this library: partitions A.off B.off RUNS, or partitions write FOLDER, which writes the operands.
#include <tbb/parallel_invoke.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "strata/bsp.h"
#include "strata/io.h"
#include "support/shapes.h"
#include "support/transform.h"

namespace {

namespace fs = std::filesystem;
using strata::ExactMesh;
using strata::Mesh;

void write(const fs::path& folder) {
  fs::create_directories(folder);
  const auto pair = [&](const std::string& name, const Mesh& a, const Mesh& b) {
    strata::write_mesh(folder / (name + "-a.off"), ExactMesh{a, {}});
    strata::write_mesh(folder / (name + "-b.off"), ExactMesh{b, {}});
  };
  for (const int level : {2, 3}) {
    const Mesh ball = strata::test::icosphere({0.1, 0.2, 0.3}, 1, level);
    pair("balls" + std::to_string(ball.triangles.size()), ball, strata::test::translated(ball, {0.5, 0.25, 0.125}));
  }
  // Every face of a ball carries a pyramid: no plane of a face has all others on one side.
  Mesh star = strata::test::icosphere({0.1, 0.2, 0.3}, 1, 2);
  std::vector<strata::Triangle> base;
  base.swap(star.triangles);
  for (const auto& [a, b, c] : base) {
    strata::Vertex tip{};
    for (std::size_t i = 0; i < 3; ++i)
      tip[i] = 0.4 * (star.vertices[a][i] + star.vertices[b][i] + star.vertices[c][i]);
    const auto number = static_cast<std::uint32_t>(star.vertices.size());
    star.vertices.push_back(tip);
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) star.triangles.push_back({p, q, number});
  }
  pair("stars" + std::to_string(star.triangles.size()), star, strata::test::translated(star, {0.5, 0.25, 0.125}));
  const Mesh cube = strata::test::box({0, 0, 0}, {1, 1, 1});
  pair("gap", cube, strata::test::translated(cube, {1 + 1e-11, 0, 0}));
}

void measure(const char* first, const char* second, int runs) {
  const ExactMesh a{strata::read_mesh(fs::path(first)).mesh, {}}, b{strata::read_mesh(fs::path(second)).mesh, {}};
  std::string seconds;
  strata::bsp::Partition<3> sum;
  for (int run = -1; run < runs; ++run) {  // the first one is not counted: the other side is warm, too
    const auto start = std::chrono::steady_clock::now();
    strata::bsp::Partition<3> of_a, of_b;  // at the same time, as `combine` builds them
    tbb::parallel_invoke([&] { of_a = strata::bsp::partition_of(a); }, [&] { of_b = strata::bsp::partition_of(b); });
    sum = of_a | of_b;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (run >= 0) seconds += (run == 0 ? "" : ", ") + std::to_string(time.count());
  }
  std::printf("{\"seconds\": [%s], \"nodes\": %zu, \"volume\": %.17g, \"area\": %.17g}\n", seconds.c_str(),
              strata::bsp::size_of_tree(sum).nodes, strata::to_nearest_double(*strata::bsp::size(sum)),
              strata::bsp::boundary_size(sum));
}

}  // namespace

int main(int count, char** arguments) {
  const std::string what = count > 1 ? arguments[1] : "";
  if (count == 3 && what == "write") {
    write(arguments[2]);
  } else if (count == 4) {
    measure(arguments[1], arguments[2], std::stoi(arguments[3]));
  } else {
    std::fprintf(stderr, "usage: partitions A.off B.off RUNS | partitions write FOLDER\n");
    return 2;
  }
  return 0;
}
