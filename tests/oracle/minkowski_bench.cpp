// minkowski_bench A B: the Minkowski sum of two solids in files, beside CGAL's if asked for; both are compared exactly.
// B may be ball:N or cube, of a twentieth of A's size (--size tells otherwise). Prints the median of the runs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "strata/convex.h"
#include "strata/io.h"

namespace {

using strata::Solid;
using strata::oracle::NefSolid;

struct Request {
  std::string first, second, output;
  std::vector<std::string> operands;  ///< where the two are written
  double size = 0.05;
  int runs = 5;
  unsigned threads = 0;
  unsigned cgal_seconds = 0;  ///< 0: not at all
};

Solid read(const std::string& path) { return Solid(strata::read_mesh(path).mesh, strata::InputClass::repair); }

double extent(const Solid& solid) {
  const strata::BoundingBox box = solid.bounding_box();
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, box.upper[i] - box.lower[i]);
  return largest;
}

Solid tool(const Request& request, const Solid& a) {
  const double size = request.size * extent(a);
  if (request.second.starts_with("ball:")) {
    const auto facets = static_cast<std::uint32_t>(std::stoul(request.second.substr(5)));
    return Solid(strata::convex::mesh_of(strata::convex::ball(size, facets).polytope));
  }
  if (request.second != "cube") return read(request.second);
  strata::Mesh cube;
  for (int k = 0; k < 8; ++k) cube.vertices.push_back({(k & 1) * size, (k >> 1 & 1) * size, (k >> 2 & 1) * size});
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return Solid(cube);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(const Request& request) {
  const Solid a = read(request.first), b = tool(request, a);
  strata::Options options;
  options.threads = request.threads;
  if (request.operands.size() == 2) {
    strata::write_mesh(request.operands[0], a.exact_mesh());
    strata::write_mesh(request.operands[1], b.exact_mesh());
  }
  std::vector<double> times;
  Solid sum;
  for (int i = 0; i < request.runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    sum = strata::convex::minkowski_sum(a, b, options);
    times.push_back(seconds_since(start));
  }
  std::sort(times.begin(), times.end());
  std::printf("%zu + %zu -> %zu triangles (%zu rational vertices), volume %.12g: strata %.4f s",
              a.mesh().triangles.size(), b.mesh().triangles.size(), sum.mesh().triangles.size(),
              sum.exact_mesh().exact.size(), static_cast<double>(sum.volume()), times[times.size() / 2]);
  std::fflush(stdout);
  if (!request.output.empty()) strata::write_mesh(request.output, sum.exact_mesh());
  if (request.cgal_seconds > 0) {
    try {
      const std::string text = strata::oracle::in_child(
          [&] {
            const NefSolid x(a.exact_mesh()), y(b.exact_mesh());
            const auto start = std::chrono::steady_clock::now();
            const NefSolid found = nef_minkowski_sum(x, y);
            const double seconds = seconds_since(start);
            const bool equal = strata::canonical_form(found.facets()) == sum.canonical();
            return ", cgal " + std::to_string(seconds) + " s, " + (equal ? "equal" : "DIFFERENT");
          },
          request.cgal_seconds);
      std::printf("%s", text.c_str());
    } catch (const strata::oracle::OracleFailed& e) {
      std::printf(", cgal: %s", e.what());
    }
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  CLI::App app("Minkowski sums beside CGAL's", "minkowski_bench");
  app.add_option("A", request.first, "A solid")->required();
  app.add_option("B", request.second, "A solid, ball:FACETS or cube")->required();
  app.add_option("--size", request.size, "Radius of the ball or side of the cube, as a part of A's extent");
  app.add_option("--runs", request.runs, "How often");
  app.add_option("-j", request.threads, "Threads");
  app.add_option("--cgal", request.cgal_seconds, "Run CGAL for up to so many seconds");
  app.add_option("--operands", request.operands, "Where both operands are written")->expected(2);
  app.add_option("-o", request.output, "Where the sum goes");
  CLI11_PARSE(app, argc, argv);
  run(request);
}
