#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

#include "strata/combine.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace strata::test {
namespace {

/// Operands and operation of one case; in all, ten of different kinds and sizes.
struct Case {
  std::string name;
  Operation operation;
  std::vector<Mesh> operands;
};

std::vector<Case> ten_cases() {
  const Mesh ball = icosphere({0, 0, 0}, 1, 5);
  const Mesh other = icosphere({0.4, 0.3, 0.2}, 1, 5);
  std::vector<Mesh> row_of_balls;
  for (int i = 0; i < 8; ++i) row_of_balls.push_back(icosphere({0.7 * i, 0.1 * i, 0}, 0.5, 3));
  return {{"union of balls", Operation::union_, {ball, other}},
          {"intersection of balls", Operation::intersection, {ball, other}},
          {"difference of balls", Operation::difference, {ball, other}},
          {"xor of balls", Operation::symmetric_difference, {ball, other}},
          {"ball with itself, relisted", Operation::union_, {ball, relisted(ball)}},
          {"nearly equal balls", Operation::difference, {ball, translated(ball, {0x1p-40, 0, 0})}},
          {"row of balls", Operation::union_, row_of_balls},
          {"meshed cubes that share a side", Operation::union_, {cube_grid(20), translated(cube_grid(20), {20, 0, 0})}},
          {"meshed cubes that overlap",
           Operation::symmetric_difference,
           {cube_grid(20), translated(cube_grid(20), {10.5, 10, 7})}},
          {"several touching solids", Operation::union_, touching_operands(7).meshes}};
}

BooleanResult run(const Case& c, unsigned threads) {
  const std::vector<MeshView> views(c.operands.begin(), c.operands.end());
  Options options;
  options.threads = threads;
  return combine(c.operation, views, options);
}

template <typename Element>
bool same_bytes(const std::vector<Element>& a, const std::vector<Element>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Element)) == 0);
}

}  // namespace

// Catches: output that follows the order in which tasks finish.
TEST_CASE("results have the same bytes with 1, 2 and 8 threads", "[corpus][threads]") {
  // Machines with fewer cores run eight threads all the same.
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const Case& c : ten_cases()) {
    CAPTURE(c.name);
    const BooleanResult one = run(c, 1);
    CHECK_FALSE(one.mesh.triangles.empty());
    for (const unsigned threads : {2U, 8U, 8U}) {
      CAPTURE(threads);
      const BooleanResult many = run(c, threads);
      CHECK(same_bytes(one.mesh.vertices, many.mesh.vertices));
      CHECK(same_bytes(one.mesh.triangles, many.mesh.triangles));
      CHECK(same_bytes(one.sources, many.sources));
    }
  }
}

}  // namespace strata::test
