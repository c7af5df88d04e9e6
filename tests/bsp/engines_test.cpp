#include <catch2/catch.hpp>

#include "strata/bsp.h"
#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/solid.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace strata {
namespace {

Options by_partitions(InputClass input = InputClass::solid) {
  Options options;
  options.input = input;
  options.engine = &bsp_engine;
  options.exact_vertices = true;
  return options;
}

BooleanResult combined(Operation operation, const std::vector<Mesh>& meshes, const Options& options) {
  const std::vector<MeshView> views(meshes.begin(), meshes.end());
  return combine(operation, std::span<const MeshView>(views), options);
}

void check_engines_agree(std::uint64_t first, std::uint64_t count) {
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const test::Operands pair = test::touching_pair(seed);
    for (const Operation operation : all_operations) {
      CAPTURE(seed, pair.kind, name(operation));
      Options options = by_partitions();
      const BooleanResult ours = combined(operation, pair.meshes, options);
      options.engine = nullptr;
      const BooleanResult usual = combined(operation, pair.meshes, options);
      const ExactMesh mesh{ours.mesh, ours.exact};
      CHECK(canonical_form(mesh) == canonical_form(ExactMesh{usual.mesh, usual.exact}));
      CHECK(topology(mesh).open_edges == 0);
      CHECK(ours.sources.size() == ours.mesh.triangles.size());
    }
  }
}

/// A triangle's normal is that of its source, or opposite to it.
void check_sources(const BooleanResult& result, const std::vector<Mesh>& meshes) {
  for (std::size_t t = 0; t < result.sources.size(); ++t) {
    const auto [operand, face] = result.sources[t];
    REQUIRE(operand < meshes.size());
    REQUIRE(face < meshes[operand].triangles.size());
    const auto axis_of = [](const Mesh& m, const Triangle& f) {
      for (int axis = 0; axis < 3; ++axis)
        if (m.vertices[f[0]][axis] == m.vertices[f[1]][axis] && m.vertices[f[0]][axis] == m.vertices[f[2]][axis])
          return std::pair{axis, m.vertices[f[0]][axis]};
      return std::pair{-1, 0.0};
    };
    CHECK(axis_of(result.mesh, result.mesh.triangles[t]) == axis_of(meshes[operand], meshes[operand].triangles[face]));
  }
}

}  // namespace

TEST_CASE("merged partitions and arrangements are the same solids, for pairs that touch", "[csg][bsp][property]") {
  check_engines_agree(0, test::rounds(200));
}

TEST_CASE("the same for 1,000 pairs", "[csg][bsp][property][slow]") { check_engines_agree(1000, 1000); }

TEST_CASE("several operands, of which some cross themselves, by merged partitions", "[csg][bsp]") {
  const std::vector<Mesh> meshes{test::box({0, 0, 0}, {4, 4, 4}), test::box({1, 1, 1}, {2, 2, 6}),
                                 test::box({2, 1, 1}, {3, 2, 6}), test::box({0, 0, 0}, {1, 1, 1})};
  for (const Operation operation : all_operations) {
    const BooleanResult ours = combined(operation, meshes, by_partitions());
    Options usual = by_partitions();
    usual.engine = nullptr;
    const BooleanResult other = combined(operation, meshes, usual);
    CHECK(canonical_form(ExactMesh{ours.mesh, ours.exact}) == canonical_form(ExactMesh{other.mesh, other.exact}));
    check_sources(ours, meshes);
  }
  const Mesh crossing[] = {test::box({0, 0, 0}, {2, 2, 2}), test::box({1, 1, 1}, {3, 3, 3})};
  const BooleanResult sum =
      combined(Operation::union_, {test::merged(crossing)}, by_partitions(InputClass::overlapping));
  CHECK(volume(ExactMesh{sum.mesh, sum.exact}) == 15);
}

TEST_CASE("trees of many operands in a row are not deep", "[csg][bsp]") {
  std::vector<Mesh> row;
  for (int i = 0; i < 150; ++i) row.push_back(test::box({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}));
  for (const Operation operation : {Operation::union_, Operation::symmetric_difference, Operation::difference}) {
    const BooleanResult result = combined(operation, row, by_partitions());
    CHECK(volume(ExactMesh{result.mesh, result.exact}) == (operation == Operation::difference ? 1 : 150));
    for (const auto& [what, count] : result.profile.counts)
      if (what == "depth") CHECK(count < 100);
  }
}

TEST_CASE("an open operand is refused by its number, and a stop is obeyed, by merged partitions", "[csg][bsp]") {
  Mesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  try {
    (void)combined(Operation::union_, {test::box({0, 0, 0}, {1, 1, 1}), open}, by_partitions());
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.operand() == 1);
  }
  CancelToken stop;
  stop.cancel();
  Options options = by_partitions();
  options.cancel = &stop;
  CHECK_THROWS_AS(combined(Operation::union_, {test::box({0, 0, 0}, {1, 1, 1})}, options), Cancelled);
}

TEST_CASE("an operand that crosses itself is refused where its tree shows it, by merged partitions", "[csg][bsp]") {
  const Mesh parts[] = {test::icosphere({0, 0, 0}, 1, 2), test::icosphere({0.5, 0.25, 0.125}, 1, 2)};
  try {
    (void)combined(Operation::union_, {test::box({0, 0, 0}, {1, 1, 1}), test::merged(parts)}, by_partitions());
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.operand() == 1);
    CHECK(error.defects().front().kind == DefectKind::self_intersection);
  }
}

TEST_CASE("formulas are not for merged partitions", "[csg][bsp]") {
  const Mesh box = test::box({0, 0, 0}, {1, 1, 1});
  const Operand operand{MeshView(box), {}, false};
  Formula formula(1);
  formula.close(formula.operand(0));
  CHECK_THROWS_AS(combine(formula, std::span(&operand, 1), by_partitions()), std::invalid_argument);
}

}  // namespace strata
