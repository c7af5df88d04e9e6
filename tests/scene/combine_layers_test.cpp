#include <array>
#include <catch2/catch.hpp>

#include "core/kernel/input_complex.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "scene/scenes.h"
#include "strata/expression.h"
#include "strata/measure.h"
#include "strata/query.h"
#include "support/touching.h"

using namespace strata;

namespace {

LayerDecomposition layers_of(const Mesh& mesh, const Origin& origin) {
  const Solid solid(mesh);
  return {scene_of({&solid, 1}), origin};
}

}  // namespace

namespace {

void check_pair(std::uint64_t seed, int origins) {
  CAPTURE(seed);
  test::Random random(seed);
  const auto pair = test::touching_pair(seed).meshes;
  const std::array<Solid, 2> solids{Solid(pair[0]), Solid(pair[1])};
  for (int n = 0; n < origins; ++n) {
    const Origin origin = test::awkward_origin(pair, random);
    CAPTURE(origin.is_point(), origin.at[0], origin.at[1], origin.at[2]);
    const LayerDecomposition a = layers_of(pair[0], origin), b = layers_of(pair[1], origin);
    const auto operation = static_cast<Operation>(random.below(4));
    const LayerDecomposition both = combine(a, b, operation);
    REQUIRE(both.validate(4).empty());
    REQUIRE(Solid(both.scene().solid(0)) == combine_solids(operation, solids));
  }
}

}  // namespace

// Catches: winding numbers that depend on the origin, at origins on corners, edges and faces too.
TEST_CASE("combinations about any origin are those of the engine", "[csg][layers][property]") {
  check_pair(GENERATE(range(std::uint64_t{0}, std::uint64_t{60})), 4);
}

TEST_CASE("combinations of 500 pairs about ten origins each are those of the engine", "[csg][layers][property][slow]") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) check_pair(seed, 10);
}

TEST_CASE("results are operands about the same origin", "[csg][layers]") {
  const Origin origin = Origin::point({.3, .2, .1});
  const LayerDecomposition a = layers_of(test::box({0, 0, 0}, {4, 4, 4}), origin);
  const LayerDecomposition b = layers_of(test::octahedron({4, 4, 4}, 3), origin);
  const LayerDecomposition c = layers_of(test::octahedron({0, 0, 0}, 2.5), origin);
  const LayerDecomposition chain = combine(combine(a, b, Operation::difference), c, Operation::union_);
  CHECK(chain.validate().empty());
  const std::array<Solid, 3> s{Solid(test::box({0, 0, 0}, {4, 4, 4})), Solid(test::octahedron({4, 4, 4}, 3)),
                               Solid(test::octahedron({0, 0, 0}, 2.5))};
  CHECK(Solid(chain.scene().solid(0)) == ((s[0] - s[1]) | s[2]));
}

TEST_CASE("decompositions that do not fit are refused", "[csg][layers]") {
  const Mesh box = test::box({0, 0, 0}, {1, 1, 1});
  const LayerDecomposition a = layers_of(box, Origin::point({2, 2, 2}));
  CHECK_THROWS_AS(combine(a, layers_of(box, Origin::direction({2, 2, 2})), Operation::union_), std::invalid_argument);
  const LayerDecomposition two(test::scene_of({box, box}), Origin::point({2, 2, 2}));
  CHECK_THROWS_AS(combine(a, two, Operation::union_), std::invalid_argument);
}

TEST_CASE("nothing in common leaves an empty decomposition", "[csg][layers]") {
  const Origin origin = Origin::point({9, 9, 9.5});
  const LayerDecomposition none = combine(layers_of(test::box({0, 0, 0}, {1, 1, 1}), origin),
                                          layers_of(test::box({1, 0, 0}, {2, 1, 1}), origin), Operation::intersection);
  CHECK(none.layer_count() == 0);
  CHECK(none.scene().face_count() == 0);
  CHECK(covering_of(none).membership({.5, .5, .5}) == Where::out);
}

namespace {

Options by_layers() {
  Options options;
  options.engine = &layer_engine;
  options.exact_vertices = true;
  return options;
}

}  // namespace

// Catches: an engine that loses a face, and one whose sources are those of the solids in between.
TEST_CASE("the engine of layers and the arrangement give the same solids", "[csg][layers][property]") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto meshes = test::touching_pair(seed).meshes;
    const std::vector<MeshView> views(meshes.begin(), meshes.end());
    for (const Operation operation : all_operations) {
      CAPTURE(seed, name(operation));
      Options options = by_layers();
      const BooleanResult ours = combine(operation, std::span<const MeshView>(views), options);
      options.engine = nullptr;
      const BooleanResult usual = combine(operation, std::span<const MeshView>(views), options);
      CHECK(canonical_form(ExactMesh{ours.mesh, ours.exact}) == canonical_form(ExactMesh{usual.mesh, usual.exact}));
      REQUIRE(ours.sources.size() == ours.mesh.triangles.size());
      for (const Source& s : ours.sources) {
        REQUIRE(s.operand < meshes.size());
        REQUIRE(s.face < meshes[s.operand].triangles.size());
      }
    }
  }
}

TEST_CASE("the engine of layers evaluates formulas, also with complements", "[csg][layers]") {
  const Expression a(Solid(test::box({0, 0, 0}, {4, 4, 4}))), b(Solid(test::octahedron({4, 4, 4}, 3))),
      c(Solid(test::octahedron({0, 0, 0}, 2.5)));
  const Expression e = (a - (b ^ c)) | (c & ~b);
  CHECK(e.evaluate(by_layers()) == e.evaluate());
  CHECK((a & ~a).evaluate(by_layers()).is_empty());
}
