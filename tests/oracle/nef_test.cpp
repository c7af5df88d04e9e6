#include "oracle/nef.h"

#include <array>
#include <catch2/catch.hpp>

#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

// The oracle is tested before it judges: known answers, and a second way of building every operand.
namespace strata::oracle {
namespace {

CanonicalForm form(const NefSolid& solid) { return canonical_form(solid.facets()); }

CanonicalForm nef(Operation operation, const Mesh& a, const Mesh& b) {
  return nef_boolean(operation, std::array{test::exact(a), test::exact(b)});
}

const Mesh unit_box = test::box({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("the oracle merges two boxes that share a side", "[oracle]") {
  const Mesh right = test::box({1, 0, 0}, {2, 1, 1});
  const CanonicalForm expected = canonical_form(test::exact(test::box({0, 0, 0}, {2, 1, 1})));
  CHECK(nef(Operation::union_, unit_box, right) == expected);
  CHECK(nef(Operation::symmetric_difference, unit_box, right) == expected);
}

TEST_CASE("the oracle is regularized: touching boxes have an empty intersection", "[oracle]") {
  for (const Vertex& corner : {Vertex{1, 0, 0}, Vertex{1, 1, 0}, Vertex{1, 1, 1}}) {
    const Mesh other = test::translated(unit_box, corner);
    CHECK(nef(Operation::intersection, unit_box, other) == CanonicalForm{});
  }
}

TEST_CASE("the oracle keeps rational vertices", "[oracle]") {
  const ExactMesh a = test::exact_box({0, 0, 0}, {1, 1, 1});
  const ExactMesh b = test::exact_box({Rational(1, 3), Rational(1, 3), Rational(1, 3)}, {1, 1, 1});
  const std::vector<NefSolid> solids{NefSolid(a), NefSolid(b)};
  CHECK(facet_volume(nef_combine(Operation::difference, solids).facets()) == Rational(19, 27));
}

TEST_CASE("the oracle builds cavities, parts and shared edges as they are", "[oracle]") {
  const std::vector<Mesh> parts{unit_box, test::translated(unit_box, {2, 0, 0})};
  for (const Mesh& mesh : {test::box_with_cavity(2), test::edge_sharing_cells(), test::vertex_sharing_cells(),
                           test::box_with_hole(), test::l_shape(), test::merged(parts)}) {
    CHECK(form(NefSolid(test::exact(mesh))) == canonical_form(test::exact(mesh)));
  }
}

TEST_CASE("the oracle builds random solids in two ways that agree", "[oracle][property]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const ExactMesh mesh = test::exact(test::lattice_solid(random));
    const CanonicalForm expected = canonical_form(mesh);
    CHECK(form(NefSolid(mesh)) == expected);
    CHECK(form(NefSolid::from_tetrahedra(mesh)) == expected);
  }
}

TEST_CASE("all ways of the oracle come to the same", "[oracle][property]") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    CAPTURE(seed);
    std::vector<ExactMesh> operands;
    for (const Mesh& mesh : test::touching_pair(seed).meshes) operands.push_back(test::exact(mesh));
    for (const Operation operation : all_operations) {
      const CanonicalForm expected = nef_boolean(operation, operands);
      for (const Way way : {Way::regularized, Way::backwards, Way::other_formula}) {
        CHECK(nef_boolean(operation, operands, way) == expected);
      }
    }
  }
}

}  // namespace strata::oracle
