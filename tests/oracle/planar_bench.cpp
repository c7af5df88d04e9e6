// planar_bench FILE: Booleans of the polygons in a file of arrays, arrays in and arrays out. Prints the median of the
// runs. The file: a count of operands, then for each a count of rings, and for each ring a count and x y pairs; all as
// binary doubles.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "strata/planar.h"

namespace {

using Ring = std::vector<strata::planar::PlanePoint>;
using Rings = std::vector<Ring>;

std::vector<Rings> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const auto number = [&file] {
    double x = 0;
    file.read(reinterpret_cast<char*>(&x), sizeof x);
    return x;
  };
  std::vector<Rings> operands(static_cast<std::size_t>(number()));
  for (Rings& rings : operands) {
    rings.resize(static_cast<std::size_t>(number()));
    for (Ring& ring : rings) {
      ring.resize(static_cast<std::size_t>(number()));
      for (strata::planar::PlanePoint& p : ring) p = {number(), number()};
    }
  }
  return operands;
}

/// Rings of nearest doubles: what other engines give.
Rings run(const std::vector<Rings>& operands, strata::planar::Operation operation) {
  std::vector<strata::planar::Loops> loops;
  for (const Rings& rings : operands) loops.push_back(strata::planar::loops_of(rings));
  const std::vector<strata::planar::Operand> all(loops.begin(), loops.end());
  const strata::planar::Region region = strata::planar::combine(all, operation);
  Rings result(region.loops.size());
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    result[l].reserve(region.loops.loop(l).size());
    for (const std::uint32_t v : region.loops.loop(l)) result[l].push_back(region.loops.places.place[v]);
  }
  return result;
}

double area_of(const Rings& rings) {
  double sum = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % ring.size()];
      sum += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  std::string path, name = "union";
  int runs = 5;
  CLI::App app("Booleans of polygons, timed", "planar_bench");
  app.add_option("FILE", path, "Arrays of the operands")->required();
  app.add_option("--operation", name, "union, intersection, difference or xor");
  app.add_option("--runs", runs, "How often");
  CLI11_PARSE(app, argc, argv);
  using strata::planar::Operation;
  const Operation operation = name == "union"          ? Operation::union_
                              : name == "intersection" ? Operation::intersection
                              : name == "difference"   ? Operation::difference
                                                       : Operation::symmetric_difference;
  const std::vector<Rings> operands = read(path);
  std::vector<double> times;
  Rings result;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();  // of the process, which has one thread
    result = run(operands, operation);
    times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  std::size_t vertices = 0;
  for (const Ring& ring : result) vertices += ring.size();
  std::printf("{\"seconds\": %.6f, \"rings\": %zu, \"vertices\": %zu, \"area\": %.15g}\n",
              times[(times.size() - 1) / 2], result.size(), vertices, area_of(result));
}
