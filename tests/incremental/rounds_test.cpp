#include "extensions/incremental/rounds.h"

#include <catch2/catch.hpp>
#include <vector>

#include "extensions/incremental/step.h"
#include "strata/incremental.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using test::Random;

namespace {

constexpr Operation operations[] = {Operation::union_, Operation::difference, Operation::symmetric_difference,
                                    Operation::intersection};

/// Each tool in a group of its own.
std::vector<ToolGroup> alone(const std::vector<Solid>& tools) {
  std::vector<ToolGroup> groups;
  for (const Solid& tool : tools) groups.push_back({{{tool, nullptr}}, bounds_of(tool)});
  return groups;
}

/// Positions of all corners, face by face in the order of the tree.
std::vector<InputComplex::Coordinates> places(const FaceTree& tree) {
  std::vector<InputComplex::Coordinates> all;
  tree.for_each([&](const WorkFace& f) {
    for (const IncrementalVertexPointer& c : f.corners()) all.push_back(c->at);
  });
  return all;
}

FaceTree after(const Solid& start, Operation operation, const std::vector<Solid>& tools, unsigned threads = 0) {
  Options options;
  options.threads = threads;
  return take_steps(FaceTree(faces_of({start, nullptr})), operation, alone(tools), options);
}

void check_against_steps(const Solid& start, const std::vector<Solid>& tools) {
  for (const Operation operation : operations) {
    CAPTURE(static_cast<int>(operation));
    IncrementalSolid one(start);
    for (const Solid& tool : tools) one = one.with(operation, tool);
    const FaceTree all = after(start, operation, tools);
    CHECK(all.determinant().value == Approx(6 * one.volume()).margin(1e-9));
    CHECK(places(all) == places(after(start, operation, tools, 1)));
  }
}

}  // namespace

// Catches: two steps of a round that cut the same face, of which one is lost or taken twice.
TEST_CASE("many pits in one face, all at the same time", "[workpiece]") {
  std::vector<Solid> pits;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) pits.emplace_back(test::octahedron({i + .5, k + .5, 1}, .4));
  const Solid plate(test::box({0, 0, 0}, {6, 6, 1}));
  check_against_steps(plate, pits);
  CHECK(after(plate, Operation::difference, pits).determinant().value / 6 == Approx(36 - 36 * 2. / 3 * .4 * .4 * .4));
}

// Catches: tools of one round that touch.
TEST_CASE("steps of rounds with tools that touch", "[workpiece][property]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Solid start(test::lattice_solid(random));
    std::vector<Solid> tools;
    for (int i = 0; i < 12; ++i) tools.emplace_back(test::lattice_solid(random));
    check_against_steps(start, tools);
  }
}

TEST_CASE("steps of rounds on a ball that has many faces", "[workpiece][property]") {
  Random random(3);
  std::vector<Solid> tools;
  for (int i = 0; i < 60; ++i) {
    const auto at = [&] { return 2 * random.unit() - 1; };
    tools.emplace_back(test::octahedron({at(), at(), at()}, .15));
  }
  check_against_steps(Solid(test::icosphere({0, 0, 0}, 1, 3)), tools);
}

TEST_CASE("a workpiece that is used up takes no more steps", "[workpiece]") {
  const Solid small(test::box({0, 0, 0}, {1, 1, 1})), large(test::box({-1, -1, -1}, {2, 2, 2})),
      beside(test::box({5, 0, 0}, {6, 1, 1}));
  CHECK(after(small, Operation::difference, {large, beside}).size() == 0);
  CHECK(after(small, Operation::intersection, {beside, large}).size() == 0);
  CHECK(after(small, Operation::symmetric_difference, {small, beside}).determinant().value == 6);
}
